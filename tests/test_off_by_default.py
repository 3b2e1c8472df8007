"""What a launch file does only where an argument or a variable has another value than usual is an info (DEP103)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.testing import lint_files

HEAD = """\
import os
import sys

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import *
from launch.substitutions import (
    AndSubstitution, EnvironmentVariable, EqualsSubstitution, LaunchConfiguration, NotEqualsSubstitution,
    NotSubstitution, OrSubstitution, PythonExpression,
)
from launch_ros.actions import Node

SIM = LaunchConfiguration('sim')
JOY = Node(package='joy', executable='joy_node')
"""
DECLARED = """\
        DeclareLaunchArgument('sim', default_value='false'), DeclareLaunchArgument('real', default_value='true'),
        DeclareLaunchArgument('cam', default_value='none'), DeclareLaunchArgument('map', default_value=''),
        DeclareLaunchArgument('gui', default_value=EnvironmentVariable('GUI', default_value='false')),
        DeclareLaunchArgument('also', default_value=SIM),
"""


def told(text: str, path: str) -> tuple[str, str]:
    package = existing_files(BACKDROPS["ament_python"])
    files = {**package, "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"), path: text}
    (only,) = (each for each in lint_files(files, ["DEP103"]).findings if "`joy`" in each.message)
    return only.severity.value, only.message


def with_argument(message: str) -> str:
    return message.partition("with `")[2].partition("`")[0]


@pytest.mark.parametrize(
    ("condition", "argument"),
    [
        ("IfCondition(SIM)", "sim:=true"),
        ("IfCondition(LaunchConfiguration('real'))", ""),
        ("UnlessCondition(LaunchConfiguration('real'))", "real:=false"),
        ("UnlessCondition(NotSubstitution(SIM))", "sim:=true"),
        ("IfCondition(EqualsSubstitution(LaunchConfiguration('cam'), 'usb'))", "cam:=usb"),
        ("IfCondition(EqualsSubstitution(LaunchConfiguration('cam'), 'none'))", ""),
        ("IfCondition(NotEqualsSubstitution(LaunchConfiguration('cam'), 'none'))", "cam:=…"),
        ("IfCondition(NotEqualsSubstitution(LaunchConfiguration('map'), ''))", "map:=…"),
        ("IfCondition(AndSubstitution(LaunchConfiguration('real'), SIM))", "real:=false"),
        ("IfCondition(OrSubstitution(LaunchConfiguration('real'), SIM))", ""),
        ("IfCondition(LaunchConfiguration('gui'))", "gui:=true"),
        ("IfCondition(LaunchConfiguration('also'))", "also:=true"),
        ("IfCondition(EnvironmentVariable('SIM', default_value='0'))", "SIM=true"),
        ("IfCondition(EnvironmentVariable('SIM'))", ""),
        ("IfCondition(LaunchConfiguration('other', default='false'))", "other:=true"),
        ("""IfCondition(PythonExpression(["'", LaunchConfiguration('cam'), "' in ['usb', 'csi']"]))""", "cam:=usb"),
        ("IfCondition(PythonExpression(['not ', LaunchConfiguration('real')]))", "real:=false"),
        ("""IfCondition(PythonExpression(["'", SIM, "'.lower() == 'true'"]))""", "sim:=true"),
        ("IfCondition(PythonExpression([LaunchConfiguration('unknown'), ' == 3']))", ""),
    ],
)
def test_conditions_of_actions(condition: str, argument: str) -> None:
    node = f"Node(package='joy', executable='joy_node', condition={condition})"
    text = HEAD.replace("JOY = Node(package='joy', executable='joy_node')\n", "")
    text += f"\n\ndef generate_launch_description():\n    return LaunchDescription([\n{DECLARED}        {node}])\n"
    level, message = told(text, "launch/a.launch.py")
    assert (level, with_argument(message)) == ("info" if argument else "warning", argument)


BODY = """

def nodes(context):
{body}


def generate_launch_description():
    return LaunchDescription([
{declared}        OpaqueFunction(function=nodes)])
"""


@pytest.mark.parametrize(
    ("test", "argument"),
    [
        ("SIM.perform(context) == 'true'", "sim:=true"),
        ("sim == 'true'", "sim:=true"),
        ("sim.lower() in ('true', '1')", "sim:=true"),
        ("sim != 'true'", ""),
        ("context.launch_configurations['sim'] == 'true'", "sim:=true"),
        ("context.perform_substitution(SIM) == 'true'", "sim:=true"),
        ("LaunchConfiguration('real').perform(context) == 'true'", ""),
        ("IfCondition(SIM).evaluate(context)", "sim:=true"),
        ("LaunchConfiguration('cam').perform(context) in ['usb', 'csi']", "cam:=usb"),
        ("LaunchConfiguration('map').perform(context)", "map:=…"),
        ("os.environ.get('SIM', '0') == '1'", "SIM=1"),
        ("os.getenv('SIM')", "SIM=…"),
        ("os.environ['ROS_DISTRO'] == 'foxy'", "ROS_DISTRO=foxy"),
        ("os.environ['ROS_DISTRO'] == 'humble'", ""),
        ("'--sim' in sys.argv", "--sim"),
        ("anything(context)", ""),
    ],
)
def test_branches_of_python(test: str, argument: str) -> None:
    lines = "    sim = SIM.perform(context)\n    if {}:\n        get_package_share_directory('joy')\n    return []"
    text = HEAD.partition("JOY")[0] + BODY.format(body=lines.format(test), declared=DECLARED)
    level, message = told(text, "launch/a.launch.py")
    assert (level, with_argument(message)) == ("info" if argument else "warning", argument)


@pytest.mark.parametrize(
    ("lines", "level"),
    [
        ("    if SIM.perform(context) == 'false':\n        return []\n    return [{}]", "info"),
        ("    if SIM.perform(context) == 'true':\n        return []\n    return [{}]", "warning"),
        ("    if SIM.perform(context) == 'false':\n        pass\n    else:\n        return [{}]", "info"),
        ("    sim = SIM.perform(context)\n    sim = read(sim)\n    if sim == 'true':\n        return [{}]", "warning"),
    ],
)
def test_what_follows_or_stands_elsewhere(lines: str, level: str) -> None:
    body = lines.format("Node(package='joy', executable='joy_node')")
    text = HEAD.partition("JOY")[0] + BODY.format(body=body, declared=DECLARED)
    assert told(text, "launch/a.launch.py")[0] == level


@pytest.mark.parametrize(("condition", "level"), [(", condition=IfCondition(SIM)", "info"), ("", "warning")])
def test_functions_that_only_such_an_action_calls(condition: str, level: str) -> None:
    body = "    return [Node(package='joy', executable='joy_node')]"
    text = HEAD.partition("JOY")[0] + BODY.format(body=body, declared=DECLARED)
    text = text.replace("function=nodes)", f"function=nodes{condition})")
    assert told(text, "launch/a.launch.py")[0] == level


@pytest.mark.parametrize(
    ("attributes", "argument"),
    [
        ('if="$(var sim)"', "sim:=true"),
        ('unless="$(not $(var sim))"', "sim:=true"),
        ('if="$(equals $(var cam) usb)"', "cam:=usb"),
        ('if="$(not-equals $(var cam) usb)"', ""),
        ('if="$(and $(var sim) true)"', "sim:=true"),
        ('if="$(or $(var sim) true)"', ""),
        ('if="$(env SIM false)"', "SIM=true"),
        ("if=\"$(eval '&quot;$(var cam)&quot; != &quot;none&quot;')\"", "cam:=…"),
        ('if="$(var unknown)"', ""),
    ],
)
def test_conditions_of_entities(attributes: str, argument: str) -> None:
    arguments = '<arg name="sim" default="false"/><arg name="cam" default="none"/>'
    text = f'<launch>{arguments}<node pkg="joy" exec="joy_node" {attributes}/></launch>\n'
    level, message = told(text, "launch/a.launch.xml")
    assert (level, with_argument(message)) == ("info" if argument else "warning", argument)


@pytest.mark.parametrize(
    "action",
    [
        "GroupAction(actions=[JOY], condition=IfCondition(SIM))",
        "TimerAction(period=3.0, actions=[JOY], condition=IfCondition(SIM))",
        "GroupAction([TimerAction(period=3.0, actions=[JOY])], condition=IfCondition(SIM))",
        "RegisterEventHandler(OnProcessExit(target_action=OTHER, on_exit=[JOY]), condition=IfCondition(SIM))",
    ],
)
def test_what_such_an_action_starts(action: str) -> None:
    text = (
        f"from launch.actions import GroupAction, RegisterEventHandler, TimerAction\n{HEAD}"
        "from launch.event_handlers import OnProcessExit\n\n"
        "OTHER = Node(package='my_pkg', executable='a')\n\n\ndef generate_launch_description():\n"
        f"    return LaunchDescription([\n{DECLARED}        OTHER, {action}])\n"
    )
    level, message = told(text, "launch/a.launch.py")
    assert (level, with_argument(message)) == ("info", "sim:=true")


def test_components_of_a_container_that_is_switched_off() -> None:
    text = HEAD.partition("JOY")[0] + (
        "from launch_ros.actions import ComposableNodeContainer\n"
        "from launch_ros.descriptions import ComposableNode\n\n\n"
        "def generate_launch_description():\n    joy = ComposableNode(package='joy', plugin='joy::Joy')\n"
        "    box = ComposableNodeContainer(\n        name='a', namespace='', package='my_pkg', executable='a',\n"
        "        composable_node_descriptions=[joy], condition=IfCondition(SIM))\n"
        f"    return LaunchDescription([\n{DECLARED}        box])\n"
    )
    assert told(text, "launch/a.launch.py")[0] == "info"
