"""DEP202 unused-dependency."""

from __future__ import annotations

from collections.abc import Iterator

from ...edits.manifest import remove_element
from ...example import Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...model.uses.unused import Unused
from ...rule import Profile, rule

USED = "  <exec_depend>rclpy</exec_depend>\n  <exec_depend>std_msgs</exec_depend>\n"
NODE = "import rclpy\nfrom std_msgs.msg import String\n"


@rule(
    "DEP202",
    "unused-dependency",
    over=Unused,
    severity=Severity.INFO,
    profile=Profile.PEDANTIC,
    examples=(
        Example(
            bad={
                "package.xml": manifest("  <exec_depend>«geometry_msgs»</exec_depend>\n" + USED),
                "my_pkg/talker.py": NODE,
            },
            good={"package.xml": manifest(USED)},
            fix=Safety.UNSAFE,
        ),
    ),
)
def unused_dependency(unused: Unused) -> Iterator[Hit]:
    """
    ## What it does
    Finds dependencies of a Python package that no import, launch file, parameter file or robot description names:
    `<depend>` and `<build_depend>`, and `<exec_depend>` of packages that hold nothing but interfaces. Any other
    `<exec_depend>` may be a node that is started by name, or a plug-in, and is left alone.

    ## Why is this bad?
    Everybody who installs the package installs it too, and `colcon build` waits for it.

    ## Fix safety
    Something outside of the package may rely on its being installed along.
    """
    manifest = unused.declared.manifest
    for dependency in unused.dependencies():
        message = (
            f"`{dependency.name}` is declared, and nothing in the package imports or names it: everybody installs it "
            "all the same; remove the line"
        )
        tag = f"<{dependency.tag}>{dependency.name}</{dependency.tag}>"
        fix = Fix(f"remove {tag}", (remove_element(manifest, dependency.element),), Safety.UNSAFE)
        yield Hit(manifest.path, dependency.span, message, fix=fix)
