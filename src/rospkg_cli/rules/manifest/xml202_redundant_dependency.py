"""XML202 redundant-dependency."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.manifest.manifest_inputs import ManifestForTargets
from ...edits.manifest import remove_element
from ...example import Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...languages.rep149_condition import can_hold_together
from ...package.dependency import Dependency
from ...package.manifest import Manifest
from ...ros.manifest import PART_OF_DEPEND
from ...rule import rule

GOOD = manifest("  <depend>rclcpp</depend>\n", build_type="ament_cmake")


@rule(
    "XML202",
    "redundant-dependency",
    over=ManifestForTargets,
    severity=Severity.ERROR,
    levels={Severity.INFO: "the condition or the version limits differ: colcon takes both"},
    examples=(
        Example(
            on="ament_cmake",
            bad={"package.xml": GOOD.replace("</depend>\n", "</depend>\n  «<exec_depend>rclcpp</exec_depend>»\n")},
            good={"package.xml": GOOD},
            fix=Safety.SAFE,
        ),
        Example(
            on="ament_cmake",
            bad={
                "package.xml": GOOD.replace(
                    "</depend>\n", '</depend>\n  «<build_depend version_gte="9">rclcpp</build_depend>»\n'
                )
            },
            good={"package.xml": GOOD},
        ),
    ),
)
def redundant_dependency(package: ManifestForTargets) -> Iterator[Hit]:
    """
    ## What it does
    Finds dependencies that another tag of the same name includes.
    It is a `build_depend`, `build_export_depend` or `exec_depend` of a name that has a `depend` as well, unless their
    conditions exclude each other; in format 1 a `test_depend` of a name that is built or run with anyway.

    ## Why is this bad?
    `<depend>` means all three. colcon refuses the manifest and builds the folder as a plain package, without its
    dependencies. Where the attributes differ it takes both, and one of them is forgotten when the dependency changes.

    ## When it is quiet
    Lines whose conditions exclude each other are left alone, and so is a test_depend or a buildtool_depend next to
    `<depend>`. Where the conditions or the version limits differ, only REP-149 forbids it: an info.

    ## References
    - [REP-149, depend](https://ros.org/reps/rep-0149.html): "cannot be used in combination with any of the three
      equivalent tags for the same package or key name"; [REP-127, test_depend](https://ros.org/reps/rep-0127.html)
    """
    manifest = package.manifest
    newer = manifest.schema_format > 1
    wholes: dict[str, list[Dependency]] = {}
    for each in manifest.dependencies:
        if each.tag in (("depend",) if newer else ("build_depend", "run_depend")):
            wholes.setdefault(each.name, []).append(each)
    for each in manifest.dependencies:
        if each.tag not in (PART_OF_DEPEND if newer else ("test_depend",)) or not each.name:
            continue
        for whole in wholes.get(each.name, ()):
            refused = whole.key == each.key
            if refused or (
                newer and can_hold_together(each.condition, whole.condition, package.targets.environments())
            ):
                yield hit(manifest, each, whole, refused)
                break


def hit(manifest: Manifest, each: Dependency, whole: Dependency, refused: bool) -> Hit:
    covered = refused or (not each.limits and whole.condition in (None, each.condition))
    if refused:
        why = "colcon builds the folder as a plain package; remove this line"
    else:
        why = f"REP-149 forbids it, as `<{whole.tag}>` includes it, and colcon takes it; "
        why += "remove this line" if covered else "keep one of the two"
    fix = Fix(f"Remove `{each.name}` from `<{each.tag}>`", (remove_element(manifest, each.element),))
    return Hit(
        manifest.path,
        each.element.span,
        f"`{each.name}` is in `<{each.tag}>` and in `<{whole.tag}>`: {why}",
        None if refused else Severity.INFO,
        related=(Related(manifest.path, whole.element.span, f"the `<{whole.tag}>`"),),
        fix=fix if covered else None,
    )
