"""XML302 unknown-build-type."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.manifest.manifest_inputs import ManifestAndFiles
from ...edits.manifest_tags import set_text
from ...example import Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...rule import rule
from ...suggest import near_names

GOOD = manifest()


@rule(
    "XML302",
    "unknown-build-type",
    over=ManifestAndFiles,
    severity=Severity.ERROR,
    levels={Severity.INFO: "it is near to no build type that is known here: an extension of colcon may know it"},
    examples=(
        Example(
            bad={"package.xml": GOOD.replace("ament_python", "«ament_pyton»")},
            good={"package.xml": GOOD},
            fix=Safety.SAFE,
        ),
        Example(
            bad={"package.xml": GOOD.replace("ament_python", "«zig»")},
            good={"package.xml": GOOD},
        ),
    ),
)
def unknown_build_type(package: ManifestAndFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds build types that neither ROS 2 nor a known extension of colcon has.
    Known are ament_cargo, ament_gradle, bazel and others. More are named in the config: `build-types = ["ours"]`.

    ## Why is this bad?
    colcon warns in one line that it doesn't know how to build the package, builds nothing, and ends with success.

    ## When it is quiet
    Types of known extensions of colcon, and those that the config names (`build-types`), are known. A type that is near
    to none of them is an info: an extension may know it.

    ## References
    - [REP-149, build_type](https://ros.org/reps/rep-0149.html)
    """
    manifest = package.manifest
    for element in manifest.build_types(package.targets):
        if element.text in package.known_build_types:
            continue
        alike = near_names(element.text, package.known_build_types)
        intended = alike[0] if alike else ""
        if intended:
            hint = f"; did you mean `{intended}`?"
            fix = Fix(f"Write `{intended}`", (set_text(manifest, element, intended),))
            yield Hit(manifest.path, manifest.span(element), describe(element.text) + hint, fix=fix)
        else:
            level = Severity.INFO if element.text else None
            hint = "; if an extension of colcon knows it, name it in the config: `build-types`"
            yield Hit(manifest.path, manifest.span(element), describe(element.text) + hint, level)


def describe(text: str) -> str:
    what = f"the build type `{text}` is not known" if text else "the build type is empty"
    return f"{what}: colcon builds nothing, and ends with success"
