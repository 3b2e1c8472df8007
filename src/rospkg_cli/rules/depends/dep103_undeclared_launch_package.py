"""DEP103 undeclared-launch-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.brought_programs import BroughtPrograms
from ...checks.depends.name_source import is_unmet_at_run
from ...checks.depends.nodes_in_code import nodes_in_code
from ...checks.depends.undeclared_launch_packages import LaunchDependencies
from ...checks.launch.absent_package import ends_with
from ...checks.launch.package_reference import PackageReference
from ...edits.brought_hits import BroughtUse, left_to_others, related
from ...edits.launch_hits import described_nodes, no_launch
from ...edits.undeclared_dependency import advice, declaration, where_absent
from ...example import Example, manifest
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...ros.implied_dependencies import LAUNCH
from ...rule import rule

DECLARED = "  <exec_depend>{}</exec_depend>\n"

BAD = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='«joint_state_publisher»', executable='joint_state_publisher')])
"""
BAD_XML = """\
<launch>
  <include file="$(find-pkg-share «nav2_bringup»)/launch/navigation_launch.py"/>
</launch>
"""


@rule(
    "DEP103",
    "undeclared-launch-package",
    over=LaunchDependencies,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "for launch itself and a desktop's terminal, where a declared dependency brings it, where an "
        "argument must turn it on, for examples and debugging, for launch files that nothing installs or names, for "
        "what no launch comes to, for nodes that other code describes, where an unreleased repository declares it in "
        "another package or installs it by apt, where package.xml has it in a comment or for older distributions "
        "alone, where a page leaves it out, where one that is named lacks it, and where it needs this package"
    },
    examples=(
        Example(
            bad={"launch/robot.launch.py": BAD, "package.xml": manifest(DECLARED.format("ros2launch"))},
            good={
                "package.xml": manifest(DECLARED.format("joint_state_publisher") + DECLARED.format("ros2launch")),
            },
            fix=Safety.SAFE,
        ),
        Example(
            bad={"launch/nav.launch.xml": BAD_XML},
            good={"package.xml": manifest(DECLARED.format("nav2_bringup"))},
            fix=Safety.SAFE,
        ),
    ),
)
def undeclared_launch_package(launch: LaunchDependencies) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages that launch files need and package.xml does not declare.
    Launch files need packages whose nodes and components they start, whose files they find or include, whose modules
    they import, whose programs they run (`xacro`, `xterm -e`), and, where package.xml names parts of launch, what reads
    them (`launch_xml`, `launch_yaml`). Launch files of tests require a test_depend. At info level count commands of
    `ros2`, controllers of ros2_controllers under their usual names, and other code that describes nodes, of tests too
    (`Node(package='…', executable='…')`).

    ## Why is this bad?
    It works where the package happens to be installed. On a clean machine `rosdep install` skips what package.xml does
    not name, and the launch stops with "package 'robot_state_publisher' not found".

    ## When it is quiet
    What `ros2 launch` needs (launch, launch_ros, rclpy, PyYAML) is there. What a declared dependency certainly installs
    or may bring, as anything may come with a package that is not here, is one info, and so is a program before a node
    (`xterm -e`) of a launch file that stops without such a package; what only an argument turns on (`sim:=true`, of an
    included file too), or a variable (`SIM=true`), by a condition or in a branch of Python, is an info that names it,
    as is a substitution or action that is bound above and only read there; so are what watches a node (`valgrind`,
    `xterm -e gdb`), desktop terminals (`gnome-terminal`), packages for examples and launch files called so
    (`debug.launch.py`), what only launch files need that nothing installs and no page or other file names, what stands
    in a function that nothing calls or behind `if="false"`, and unknown packages where a `.repos` file lists
    repositories that are not here, or a README links to theirs, a script or page clones it, or builds it from a folder
    that colcon passes by, or that begin like this package and no other, and what another package of the repository
    declares, or a list or a script of it installs (apt alone), where nothing shows a release, and what launch files for
    a part need (`simulator.launch.py`) that a page leaves out of a build (`colcon build --packages-up-to arm # without
    the simulator`), what a page or script calls optional by name (`## MAVROS (optional)`), and what one of the named
    distributions lacks. Left out are computed names, uses that catch PackageNotFoundError or ask (`if 'pkg' in
    get_packages_with_prefixes()`), files for ROS 1, actions that nothing adds, a name that setup.py marks (SET401), and
    what modules import (DEP101). What needs this one (a circle) is an info; none, if it declares it.

    ## Fix safety
    Unsafe where no released package has the name, a named distribution lacks it in format 2 (which has no conditions),
    a comment of package.xml leaves it out, or another name may be intended.

    ## References
    - REP-149, exec_depend
    """
    brought: list[BroughtUse] = []
    for tests, tag in ((False, "exec_depend"), (True, "test_depend")):
        missing = launch.asked_for(tests=tests)
        if not tests and missing.keys() & LAUNCH:
            yield no_launch(launch.declared, {name: missing.pop(name) for name in sorted(missing.keys() & LAUNCH)})
        bringers = {**BroughtPrograms(missing, launch).bringers(), **launch.declared.bringers(missing, runs=not tests)}
        for name, uses in missing.items():
            bringer = bringers.get(name)
            if bringer and (bringer.is_certain or launch.unknown.intended(name) is None):
                brought.append(BroughtUse(name, bringer, tag, uses[0].path, uses[0].span))
            else:
                yield undeclared(launch, tag, name, uses)
    for tests, tag in ((False, "exec_depend"), (True, "test_depend")):
        nodes = ((name, uses[0].path, uses[0].span) for name, uses in nodes_in_code(launch, tests=tests).items())
        yield from described_nodes(launch.declared, sorted(nodes), tag)
    yield from left_to_others(launch.declared, brought, "used by launch files")


def undeclared(launch: LaunchDependencies, tag: str, name: str, uses: list[PackageReference]) -> Hit:
    uses = sorted(launch.needs.with_included(uses), key=lambda use: (bool(use.only_with), launch.idle.is_idle(use)))
    declared, first = launch.declared, uses[0]
    if intended := launch.unknown.intended(name):
        message = f"`{name}` is known nowhere, and this launch file {first.does} it: did you mean `{intended}`?"
        fix = Fix(f"write `{intended}`", (Edit(first.path, first.span, intended),), Safety.UNSAFE)
        fix_or_none = fix if launch.is_written(first) else None
    else:
        ends = ends_with(first, name, where_absent(declared, name, built=tag == "test_depend"))
        message = (
            f"`{name}` is not declared, and this launch file {first.does} it: {ends}; {advice(declared, tag, name)}"
        )
        fix_or_none = declaration(declared, tag, name)
    is_elsewhere = intended is None and (is_unmet_at_run(declared, name) or launch.unknown.is_fetched(name))
    is_aside = launch.idle.is_left(uses) or (tag == "exec_depend" and launch.idle.is_for_examples(name, uses))
    left = "" if intended else launch.left_out.why(name, (use.path for use in uses))
    mild = is_elsewhere or is_aside or first.only_with or left or all(use.is_usual for use in uses)
    places = related((use.path, use.span) for use in uses)
    return Hit(first.path, first.span, f"{message}{left}", Severity.INFO if mild else None, places, fix_or_none)
