"""XML201 duplicate-dependency."""

from __future__ import annotations

from collections.abc import Iterator

from ...edits.manifest import remove_element
from ...example import Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...package.dependency import Dependency
from ...package.manifest import Manifest
from ...rule import rule

ONCE = manifest("  <exec_depend>rclpy</exec_depend>\n  <exec_depend>tf2_ros</exec_depend>\n")
CMAKE = manifest("  <depend>rclcpp</depend>\n", build_type="ament_cmake")


@rule(
    "XML201",
    "duplicate-dependency",
    over=Manifest,
    severity=Severity.INFO,
    levels={Severity.ERROR: "a `<depend>` is declared twice: colcon refuses the manifest"},
    examples=(
        Example(
            bad={
                "package.xml": ONCE.replace(
                    "rclpy</exec_depend>\n", "rclpy</exec_depend>\n  «<exec_depend>rclpy</exec_depend>»\n"
                )
            },
            good={"package.xml": ONCE},
            fix=Safety.SAFE,
        ),
        Example(
            on="ament_cmake",
            bad={"package.xml": CMAKE.replace("</depend>\n", "</depend>\n  «<depend>rclcpp</depend>»\n")},
            good={"package.xml": CMAKE},
            fix=Safety.SAFE,
        ),
    ),
)
def duplicate_dependency(manifest: Manifest) -> Iterator[Hit]:
    """
    ## What it does
    Finds dependencies that are declared twice with the same tag, condition and version limits.

    ## Why is this bad?
    One of them is forgotten when the dependency changes. Two equal `<depend>` are refused by colcon, which then builds
    the folder as a plain package, without its dependencies.

    ## When it is quiet
    The same name under another tag (XML202), condition or version limit is another dependency. Two equal lines are an
    info, but for `<depend>`, which colcon refuses.

    ## References
    - [REP-149, depend](https://ros.org/reps/rep-0149.html)
    """
    seen: dict[object, Dependency] = {}
    for each in manifest.dependencies:
        first = seen.setdefault((each.tag, each.key), each)
        if first is each or not each.name:
            continue
        refused = each.tag == "depend"
        lost = "colcon builds the folder as a plain package" if refused else "once is enough"
        yield Hit(
            manifest.path,
            each.element.span,
            f"`{each.name}` is in `<{each.tag}>` twice: {lost}; remove this line",
            Severity.ERROR if refused else None,
            (Related(manifest.path, first.element.span, "the first"),),
            Fix(f"Remove the second `{each.name}`", (remove_element(manifest, each.element),)),
        )
