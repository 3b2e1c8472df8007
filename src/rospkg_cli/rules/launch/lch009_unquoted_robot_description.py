"""LCH009 unquoted-robot-description."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.robot_description import RobotDescriptions
from ...checks.launch.robot_parameters import RobotParameter
from ...edits.launch_file import import_name, pass_through
from ...example import Example, manifest
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...package.launch.launch_file import LaunchFile
from ...package.line_width import line_width
from ...rule import rule

NEEDED = "".join(f"  <exec_depend>{name}</exec_depend>\n" for name in ("robot_state_publisher", "ros2launch", "xacro"))
ROBOT = '<robot name="robot">\n  <!-- base: on the floor -->\n  <link name="base_link"/>\n</robot>\n'
COMMAND = "Command(['xacro ', FindPackageShare('my_pkg'), '/urdf/robot.urdf.xacro'])"
GOOD = f"""\
from launch import LaunchDescription
from launch.substitutions import Command
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    description = {COMMAND}
    return LaunchDescription([
        Node(
            package='robot_state_publisher',
            executable='robot_state_publisher',
            parameters=[{{'robot_description': ParameterValue(description, value_type=str)}}],
        ),
    ])
"""
BAD = GOOD.replace("ParameterValue(description, value_type=str)", "«description»").replace(
    "from launch_ros.parameter_descriptions import ParameterValue\n", ""
)

BETTER = "wrap it in `ParameterValue(…, value_type=str)`"


@rule(
    "LCH009",
    "unquoted-robot-description",
    over=RobotDescriptions,
    severity=Severity.WARNING,
    levels={Severity.INFO: "no file of the robot is known that YAML can't read"},
    examples=(
        Example(
            bad={
                "package.xml": manifest(NEEDED),
                "urdf/robot.urdf.xacro": ROBOT,
                "launch/a.launch.py": BAD,
            },
            good={"launch/a.launch.py": GOOD},
            fix=Safety.SAFE,
        ),
    ),
)
def unquoted_robot_description(robots: RobotDescriptions) -> Iterator[Hit]:
    """
    ## What it does
    Finds robot descriptions from a command that are not wrapped in `ParameterValue`.
    A command (`xacro …`, `cat x.urdf`) prints the robot, and its output is a parameter without `ParameterValue(…,
    value_type=str)`. Where no file of that robot in this package holds what YAML can't read, it works so far, and all
    such places of the package are one info.

    ## Why is this bad?
    launch_ros reads the output as YAML. A colon and a space in any comment of the robot, and the launch stops with
    "Unable to parse the value of parameter robot_description as yaml".

    ## When it is quiet
    Comments that xacro drops do not count: those right before one of its own elements. A command whose text names no
    robot is left alone.

    ## Fix safety
    The value is wrapped, over several lines where one would be longer than the package's linters allow (99 columns, if
    they say nothing), and ParameterValue is imported: the parameter is the same string.
    """
    works: list[tuple[LaunchFile, RobotParameter]] = []
    found = tuple(robots.parameters())
    width = line_width(robots.files) if found else 0
    for file, each, robot in found:
        if not robot:
            works.append((file, each))
            continue
        message = (
            f"launch_ros reads `{each.parameter}` as YAML, and `{robot}` holds `: ` or ` #`: {ends(each)}; {BETTER}"
        )
        yield Hit(file.path, each.span, message, fix=wrapped(width, (file, each)))
    if works:
        (file, each), *others = works
        message = f"launch_ros reads `{each.parameter}` as YAML: at a `: ` in the robot {ends(each)}; {BETTER}"
        again = tuple(Related(other.path, at.span, "here too") for other, at in others)
        yield Hit(file.path, each.span, message, Severity.INFO, again, wrapped(width, *works))


def ends(each: RobotParameter) -> str:
    return f'the launch stops with "Unable to parse the value of parameter {each.parameter} as yaml"'


def wrapped(width: int, *places: tuple[LaunchFile, RobotParameter]) -> Fix | None:
    """Return the fix of all these places; none where one of them can't be fixed."""
    edits: list[Edit] = []
    for file, each in places:
        if not each.is_in_dict or file.python is None:
            return None
        found = pass_through(file.python, each.span, "ParameterValue", "value_type=str", width)
        if not found:
            return None
        edits += found
        imported = import_name(file.python, "launch_ros.parameter_descriptions", "ParameterValue")
        edits += [edit for edit in imported if edit not in edits]
    return Fix("pass it as a string", tuple(edits), Safety.SAFE)
