"""XML203 self-dependency."""

from __future__ import annotations

from collections.abc import Iterator

from ...edits.manifest import remove_element
from ...example import Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...package.manifest import Manifest
from ...ros.manifest import RELATIONS
from ...rule import rule

GOOD = manifest("  <depend>rclcpp</depend>\n", build_type="ament_cmake")
GROUP = manifest("  <member_of_group>my_drivers</member_of_group>\n", build_type="ament_cmake")


@rule(
    "XML203",
    "self-dependency",
    over=Manifest,
    severity=Severity.ERROR,
    examples=(
        Example(
            on="ament_cmake",
            bad={"package.xml": GOOD.replace("</depend>\n", "</depend>\n  «<exec_depend>my_pkg</exec_depend>»\n")},
            good={"package.xml": GOOD},
            fix=Safety.SAFE,
        ),
        Example(
            on="ament_cmake",
            bad={"package.xml": GROUP.replace("  <member", "  «<group_depend>my_drivers</group_depend>»\n  <member")},
            good={"package.xml": GROUP},
            fix=Safety.SAFE,
        ),
    ),
)
def self_dependency(manifest: Manifest) -> Iterator[Hit]:
    """
    ## What it does
    Finds a package that depends on itself, or on a group that it is a member of.

    ## Why is this bad?
    colcon refuses the manifest and builds the folder as a plain package, without its dependencies.

    ## When it is quiet
    Only the package's own name, and a group that it is a member of, count. `<replace>` and `<conflict>` of itself,
    which Debian knows, are left alone.

    ## References
    - [REP-149, Dependencies](https://ros.org/reps/rep-0149.html): "No package may directly or indirectly depend on
      itself."
    """
    lost = "colcon builds the folder as a plain package; remove this line"
    for each in manifest.dependencies:
        if each.name and each.name == manifest.name and each.tag not in RELATIONS:
            fix = Fix(f"Remove `{each.name}`", (remove_element(manifest, each.element),))
            message = f"`{each.name}` depends on itself in `<{each.tag}>`: {lost}"
            yield Hit(manifest.path, each.element.span, message, fix=fix)
    groups = {element.text for element in manifest.all("member_of_group")}
    for element in manifest.all("group_depend"):
        if element.text in groups:
            fix = Fix(f"Remove the dependency on `{element.text}`", (remove_element(manifest, element),))
            message = f"the package depends on the group `{element.text}`, and is a member of it: {lost}"
            yield Hit(manifest.path, element.span, message, fix=fix)
