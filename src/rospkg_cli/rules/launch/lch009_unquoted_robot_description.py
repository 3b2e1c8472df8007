"""LCH009 unquoted-robot-description."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.robot_description import RobotDescriptions, RobotParameter
from ...edits.launch_file import import_name, wrap
from ...example import Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...package.launch.launch_file import LaunchFile
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
    value_type=str)`. It is a warning where a file of that robot, in this package, holds what YAML can't read; elsewhere
    it works so far, and is reported at info level.

    ## Why is this bad?
    launch_ros reads the output as YAML. A colon and a space in any comment of the robot, and the launch stops with
    "Unable to parse the value of parameter robot_description as yaml".

    ## Fix safety
    The value is wrapped, and ParameterValue is imported: the parameter is the same string.
    """
    for each, robot in robots.parameters():
        ends = f'the launch stops with "Unable to parse the value of parameter {each.parameter} as yaml"'
        if robot:
            message = f"launch_ros reads `{each.parameter}` as YAML, and `{robot}` holds `: ` or ` #`: {ends}"
        else:
            message = f"launch_ros reads `{each.parameter}` as YAML: as soon as the robot holds a `: `, {ends}"
        message += "; wrap it in `ParameterValue(…, value_type=str)`"
        yield Hit(
            robots.file.path, each.span, message, None if robot else Severity.INFO, fix=wrapped(robots.file, each)
        )


def wrapped(file: LaunchFile, each: RobotParameter) -> Fix | None:
    if not each.is_in_dict or file.python is None:
        return None
    edits = wrap(file.path, each.span, "ParameterValue(", ", value_type=str)")
    imported = import_name(file.python, "launch_ros.parameter_descriptions", "ParameterValue")
    return Fix("pass it as a string", (*edits, *imported), Safety.SAFE)
