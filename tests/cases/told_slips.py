"""Slips of a sign or a name in launch files, told in small: a comma, a text for a list, a name for two actions."""

from __future__ import annotations

from rospkg_cli.example import Example

from .shown_launch_calls import HEAD, NEEDED, node, python

JOINS = """\
from launch.substitutions import PathJoinSubstitution
from launch_ros.parameter_descriptions import ParameterValue
"""
BUILDS = "from moveit_configs_utils import MoveItConfigsBuilder\n"


def body(*lines: str) -> Example:
    """A launch file whose function has some statements."""
    text = "".join(f"    {each}\n" for each in lines)
    text = f"{HEAD}\n\ndef generate_launch_description():\n{text}"
    return Example(bad={"package.xml": NEEDED, "launch/a.launch.py": text}, good={})


COMMAS = (
    body("x = LogInfo(msg='a'),", "return LaunchDescription([x])"),
    body("x = LogInfo(msg='a'),", "return LaunchDescription([*x])"),
    body("x = (LogInfo(msg='a'),)", "return LaunchDescription([x])"),
    body("x = LogInfo(msg='a'),", "y = LaunchDescription()", "y.add_action(x)", "return y"),
    body("x = IfCondition(a),", "return LaunchDescription([LogInfo(msg='a', condition=x)])"),
)
ADDED = body(
    "found = LaunchDescription([DeclareLaunchArgument('a'), DeclareLaunchArgument('b')])",
    "found.add_action(LogInfo(msg='x'))",
    "found.add_action([LogInfo(msg='x')])",
    "found.add_action(a)",
    "found.add_action(None)",
    "found.add_entity('x')",
    "found.add_action(unknown)",
    "found.add_action(ComposableNode(package='p', plugin='p::P', name='n'))",
    "return found",
)
JOINED = python(
    *(
        f"LogInfo(msg=PathJoinSubstitution({each}))"
        for each in ("'maps'", "'m'", "f'maps/{unknown}'", "['maps', a]", "('maps',)", "a", "5", "[5]", "unknown")
    ),
    before=JOINS,
)
OBJECTS = python(
    *node(
        "parameters=[moveit]",
        "parameters=[moveit.to_dict(), moveit.robot_description]",
        "parameters=[{'arm': moveit, 'level': {'arm': moveit}}]",
        "parameters=[{'arm': takes, 'leg': takes()}]",
        "parameters=[takes]",
        "parameters=[ParameterValue('a')]",
        "parameters=[{'a': ParameterValue('a')}]",
        "parameters=[{'a': LogInfo(msg='x')}, LogInfo(msg='x')]",
    ),
    before=f"{JOINS}{BUILDS}moveit = MoveItConfigsBuilder('arm').to_moveit_configs()\n\n\ndef takes():\n    return 5\n",
)
TWICE = (
    body("x = LogInfo(msg='a')", "x = LogInfo(msg='b')", "return LaunchDescription([x])"),
    body("x = LogInfo(msg='a')", "x = LogInfo(msg='a')", "return LaunchDescription([x])"),
    body("x = LogInfo(msg='a')", "x = GroupAction([x])", "return LaunchDescription([x])"),
    body("x = LogInfo(msg='a')", "if unknown:", "    x = LogInfo(msg='b')", "return LaunchDescription([x])"),
    body("x = LogInfo(msg=5)", "x = LogInfo(msg='b')", "return LaunchDescription([x])"),
    body("x = Node(package='p', executable='e')", "x, y = unknown", "return LaunchDescription([x])"),
)
CASES = {"LCH014": (*COMMAS, ADDED, JOINED, OBJECTS), "LCH018": TWICE}
