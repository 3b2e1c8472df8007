"""DEP106 undeclared-urdf-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.robot_uses import RobotUses
from ...edits.manifest import add_dependency
from ...example import Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule
from ...suggest import did_you_mean

DECLARED = "  <exec_depend>{}</exec_depend>\n"

ROBOT = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">
  <xacro:include filename="«$(find ur_description)/urdf/ur_macro.xacro»"/>
  <link name="base"/>
</robot>
"""
LAYOUT = """\
Visualization Manager:
  Displays:
    - Class: «grid_map_rviz_plugin/GridMap»
"""


@rule(
    "DEP106",
    "undeclared-urdf-package",
    over=RobotUses,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "for plugins of robots and of RViz configs, or in a package that launches nothing, and where "
        "package.xml has it in a comment"
    },
    examples=(
        Example(
            bad={"urdf/robot.urdf.xacro": ROBOT},
            good={"package.xml": manifest(DECLARED.format("ur_description"))},
            fix=Safety.SAFE,
        ),
        Example(
            bad={"rviz/robot.rviz": LAYOUT},
            good={"package.xml": manifest(DECLARED.format("grid_map_rviz_plugin"))},
            fix=Safety.SAFE,
        ),
    ),
)
def undeclared_urdf_package(robots: RobotUses) -> Iterator[Hit]:
    """
    ## What it does
    Finds undeclared packages that robots, worlds, RViz configs and parameter files need.
    Installed files need packages whose files they name (`package://…`, `$(find …)`) and whose plugins they name
    (`nav2_navfn_planner::NavfnPlanner`). What comes with RViz itself is left alone, and so are plugins that come with a
    declared package, such as those of `navigation2`.

    ## Why is this bad?
    It works where the package happens to be installed. On a clean machine `rosdep install` skips what package.xml does
    not name: xacro stops, meshes are missing, and nodes stop because their plugin can't be loaded.

    ## References
    - REP-149, exec_depend
    """
    around, aside = robots.launch.known_names, robots.declared.commented_out
    for name, uses in robots.missing().items():
        first, *others = uses
        hint = did_you_mean(name, around) if robots.launch.is_unknown_package(name) else ""
        line = f"<exec_depend>{name}</exec_depend>"
        message = (
            f"package.xml does not declare `{name}`, {first.usage}{hint}: on a clean machine rosdep does not install "
            f"it, and {first.consequence}; add {line}"
        )
        fix = None if hint else Fix(f"add {line}", (add_dependency(robots.declared.manifest, "exec_depend", name),))
        related = tuple(Related(use.path, use.span, "and here") for use in others[:3])
        mild = name in aside or all(use.is_optional for use in uses)
        yield Hit(first.path, first.span, message, Severity.INFO if mild else None, related, fix)
