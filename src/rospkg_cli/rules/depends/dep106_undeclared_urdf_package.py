"""DEP106 undeclared-urdf-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.name_source import is_unmet_at_run
from ...checks.depends.robot_use import RobotUse
from ...checks.depends.robot_uses import RobotUses
from ...checks.enumeration import enumerated
from ...edits.brought_hits import BroughtUse, left_to_others, related
from ...edits.undeclared_dependency import advice, declaration, where_absent
from ...example import Example, manifest
from ...finding import Hit, Safety, Severity
from ...rule import rule

SHOWN = 3
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
        Severity.INFO: "for plugins of robots and of RViz configs, in a package that launches nothing, in a file that "
        "nothing opens, and where an argument must turn it on, a declared dependency brings or may bring it, an "
        "unreleased repository declares it in another package or installs it by apt, or package.xml has it in a "
        "comment or for older distributions alone, a named distribution lacks it, or it needs this package itself"
    },
    examples=(
        Example(
            bad={"urdf/robot.urdf.xacro": ROBOT, "README.md": "    xacro urdf/robot.urdf.xacro > robot.urdf\n"},
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
    (`nav2_navfn_planner::NavfnPlanner`), and parameter files those of `interface_type: std_srvs/srv/Empty`. What
    parameter files look for (`$(find-pkg-share …)`) is an info; a former name in their `package://…` is reported where
    a package here has the file. Parameter files of tests need a test_depend where launch files start what loads
    plugins.

    ## Why is this bad?
    It works where the package happens to be installed. On a clean machine `rosdep install` skips what package.xml does
    not name: xacro stops, meshes are missing, and nodes stop because their plugin can't be loaded.

    ## When it is quiet
    What a declared dependency certainly installs is one info, which names who brings it. What may come with a declared
    one is another: with a package that is neither here nor in the table of what is installed with what, anything may
    come. Left alone are files that are not installed, what comes with RViz itself, plugins of a metapackage, or of a
    package whose node is launched, or that such a one needs itself, and what launch files need as well (DEP103).
    Plugins of robots and RViz configs are infos, and so are those of parameter files in a package that launches nothing
    that loads plugins (controller_manager, nav2, MoveIt), or in a file that no launch file for ROS 2 names or puts
    together, nor an opened robot: others may use it without them. So is a controller that is not spawned where launch
    files spawn others of its file (they may look it up, as `loaded["arm"]["default"]`), or load none at all, one whose
    type is in a comment, a plugin that no list next to it names (`plugins: [static_layer]`), a type that comes with the
    node which loads it (`geometry_msgs` with joy_teleop), and what a robot needs that nothing opens, or only where an
    argument turns it on (`GAZEBO:=true`), or a variable that nothing here sets, in a macro that nothing calls, in the
    default of an argument that each launch file gives, or in a property that nothing reads, what stands as `$(find …)`
    in SDF without a word of xacro, and what another package of the repository declares, or a list or a script of it
    installs (apt alone), where nothing shows a release, and unknown packages that a script clones, or builds from a
    folder here that colcon passes by, and what one of the distributions lacks that the repository names, while others
    have it. A package here that needs this one itself is an info, for to declare it would make a circle; where it
    declares this one, nothing is said. What a page or a comment calls optional is an info, too.

    ## Fix safety
    The fix is unsafe where no released package has the name, or a comment of package.xml leaves it out. Where this
    package or one next to it has the same files, or the name is a slip of another, there is none: correct the path.

    ## References
    - REP-149, exec_depend
    """
    declared = robots.declared
    for tests, tag in ((False, "exec_depend"), (True, "test_depend")):
        brought: list[BroughtUse] = []
        for name, uses in (robots.missing_in_tests() if tests else robots.missing()).items():
            is_slip = robots.launch.unknown.intended(name) or len(robots.renamed.owner_of(name)[1]) > 1
            bringer = None if is_slip else declared.bringers([name], runs=not tests).get(name)
            if bringer:
                brought.append(BroughtUse(name, bringer, tag, uses[0].path, uses[0].span))
            else:
                yield undeclared(robots, tag, name, uses)
        who = "the parameters of tests" if tests else "robots, worlds or parameters"
        yield from left_to_others(declared, brought, f"used by {who}")


def undeclared(robots: RobotUses, tag: str, name: str, uses: list[RobotUse]) -> Hit:
    declared, first = robots.declared, uses[0]
    owner, files = robots.renamed.owner_of(name)
    intended = owner or robots.launch.unknown.intended(name)
    todo = f"did you mean `{intended}`{having(files)}?" if intended else advice(declared, tag, name)
    message = f"`{name}` is not declared, {first.usage}: {where_absent(declared, name)} {first.consequence}; {todo}"
    left = "" if intended else robots.launch.left_out.why(name, (use.path for use in uses))
    message += first.why if all(use.is_optional for use in uses) else left
    fix = None if intended else declaration(declared, tag, name)
    is_elsewhere = is_unmet_at_run(declared, name) or (intended is None and robots.launch.unknown.is_fetched(name))
    mild = is_elsewhere or left or all(use.is_optional for use in uses)
    places = related((use.path, use.span) for use in uses)
    return Hit(first.path, first.span, message, Severity.INFO if mild else None, places, fix)


def having(files: list[str]) -> str:
    """Return the end of a sentence that names a package: the files that it has."""
    if not files:
        return ""
    shown = [f"`{each}`" for each in files[:SHOWN]]
    if len(files) > SHOWN:
        shown.append(f"{len(files) - SHOWN} more")
    return f", which has {enumerated(shown)}"
