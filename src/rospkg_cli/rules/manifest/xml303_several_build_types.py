"""XML303 several-build-types."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.manifest.manifest_inputs import ManifestForTargets
from ...example import Example, manifest
from ...finding import Hit, Related, Severity
from ...languages.rep149_condition import can_hold_together
from ...rule import rule

GOOD = manifest()


@rule(
    "XML303",
    "several-build-types",
    over=ManifestForTargets,
    severity=Severity.ERROR,
    examples=(
        Example(
            bad={
                "package.xml": GOOD.replace(
                    "</build_type>\n", "</build_type>\n    <build_type>«ament_python»</build_type>\n"
                )
            },
            good={"package.xml": GOOD},
        ),
    ),
)
def several_build_types(package: ManifestForTargets) -> Iterator[Hit]:
    """
    ## What it does
    Finds a second `<build_type>` that holds at the same time as the first.
    Conditions are evaluated.

    ## Why is this bad?
    REP-149 says that the last one counts. colcon does not think so: it warns, builds the folder as a plain package,
    forgets its dependencies, and `ros2 run` does not find it.

    ## When it is quiet
    Build types whose conditions exclude each other, as of a package for ROS 1 and ROS 2, are left alone.

    ## References
    - [REP-149, build_type](https://ros.org/reps/rep-0149.html): "Only one build type should be active after conditions
      are evaluated."
    """
    manifest, environments = package.manifest, package.targets.environments()
    found = list(manifest.build_types(package.targets))
    for index, element in enumerate(found):
        for other in found[:index]:
            if can_hold_together(other.get("condition"), element.get("condition"), environments):
                message = (
                    f"`{element.text}` is a second build type next to `{other.text}`: colcon builds the folder as a "
                    f"plain package; keep one, or give each a condition (`$ROS_VERSION == 2`)"
                )
                related = (Related(manifest.path, manifest.span(other), "the first"),)
                yield Hit(manifest.path, manifest.span(element), message, related=related)
                break
