"""DEP103 undeclared-launch-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.undeclared_launch_packages import LaunchDependencies
from ...checks.launch.package_references import PackageReference
from ...edits.manifest import add_dependency
from ...example import Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...ros.implied_dependencies import LAUNCH
from ...rule import rule
from ...suggest import did_you_mean

DECLARED = "  <exec_depend>{}</exec_depend>\n"

BAD = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='«robot_state_publisher»', executable='robot_state_publisher')])
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
        Severity.INFO: "for launch itself, which users of launch files have, for examples and demos, "
        "for nodes that other code describes, and where package.xml has it in a comment"
    },
    examples=(
        Example(
            bad={"launch/robot.launch.py": BAD, "package.xml": manifest(DECLARED.format("ros2launch"))},
            good={
                "package.xml": manifest(DECLARED.format("robot_state_publisher") + DECLARED.format("ros2launch")),
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
    Launch files need packages whose nodes and components they start, whose files they find or include, whose programs
    (`xacro`) they run, and whose modules they import. Names that are computed when the file runs are left alone. A
    dependency on `ros2launch` implies launch, launch_ros, launch_xml, launch_yaml and ament_index_python. Launch files
    of tests require a test_depend. Other installed code that describes nodes (`Node(package='…', executable='…')`)
    counts too, at info level.

    ## Why is this bad?
    It works where the package happens to be installed. On a clean machine `rosdep install` skips what package.xml does
    not name, and the launch stops with "package 'robot_state_publisher' not found".

    ## References
    - REP-149, exec_depend
    """
    for tests, tag in ((False, "exec_depend"), (True, "test_depend")):
        missing = launch.missing(tests=tests)
        if not tests and missing.keys() & LAUNCH:
            yield no_launch(launch, {name: missing.pop(name) for name in sorted(missing.keys() & LAUNCH)})
        for name, uses in missing.items():
            yield undeclared(launch, tag, name, uses)
    for name, uses in launch.nodes_in_code().items():
        yield undeclared(launch, "exec_depend", name, uses, "this code", mild=True)


def undeclared(
    launch: LaunchDependencies,
    tag: str,
    name: str,
    uses: list[PackageReference],
    who: str = "this launch file",
    *,
    mild: bool = False,
) -> Hit:
    first, *others = uses
    hint = did_you_mean(name, launch.known_names) if launch.is_unknown_package(name) else ""
    line = f"<{tag}>{name}</{tag}>"
    message = (
        f"package.xml does not declare `{name}`, but {who} {first.does} it{hint}: on a clean machine rosdep "
        f"does not install it and the launch fails with \"package '{name}' not found\"; add {line}"
    )
    fix = None if hint else Fix(f"add {line}", (add_dependency(launch.declared.manifest, tag, name),))
    related = tuple(Related(use.path, use.span, "and here") for use in others[:3])
    mild = mild or all(launch.is_example(use.path) for use in uses)
    level = Severity.INFO if mild or name in launch.declared.commented_out else None
    return Hit(first.path, first.span, message, level, related, fix)


def no_launch(launch: LaunchDependencies, missing: dict[str, list[PackageReference]]) -> Hit:
    """Ask for ros2launch once, whatever of launch itself is missing."""
    first = min((use for uses in missing.values() for use in uses), key=lambda use: (use.path, use.span))
    line = "<exec_depend>ros2launch</exec_depend>"
    names = " and ".join(f"`{name}`" for name in missing)
    message = (
        f"package.xml does not declare {names}, which this launch file needs: where nothing else brings them, "
        f"`ros2 launch` is not there to start it; add {line}, which implies them"
    )
    fix = Fix(f"add {line}", (add_dependency(launch.declared.manifest, "exec_depend", "ros2launch"),))
    return Hit(first.path, first.span, message, Severity.INFO, fix=fix)
