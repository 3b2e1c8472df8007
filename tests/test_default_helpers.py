"""What launch files convert by a function of their own is known by the default of the argument (DEP103)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

LAUNCH = """\
import ast

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


{}


def go(context):
    if {}:
        return [Node(package='mavros', executable='mavros_node')]
    return []


def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('sim', default_value='{}'), OpaqueFunction(function=go)])
"""
SIM = "LaunchConfiguration('sim').perform(context)"
SHORT = "def to_bool(value):\n    '''Return the truth.'''\n    return value.lower() in ('true', '1')"
LONG = (
    "def to_bool(value: str) -> bool:\n    if isinstance(value, bool):\n        return value\n"
    "    if value.strip().lower() in ('true', '1', 'yes'):\n        return True\n    return False"
)
OPEN = "def to_bool(value):\n    for each in WORDS:\n        print(each)\n    return value in WORDS"


def level(helper: str, condition: str, default: str) -> str:
    needs = manifest("  <exec_depend>ros2launch</exec_depend>\n")
    text = LAUNCH.format(helper, condition, default)
    (only,) = lint_files({"package.xml": needs, "launch/a.launch.py": text}, ["DEP103"]).findings
    return only.severity.value


@pytest.mark.parametrize(
    ("helper", "condition"),
    [
        (SHORT, f"to_bool({SIM})"),
        (LONG, f"to_bool({SIM})"),
        ("", f"ast.literal_eval({SIM}.capitalize())"),
        ("", f"bool(strtobool({SIM}))"),
    ],
)
def test_what_is_off(helper: str, condition: str) -> None:
    assert level(helper, condition, "false") == "info"
    assert level(helper, condition, "true") == "warning"
    assert level(helper, f"not {condition}", "false") == "warning"


def test_what_is_not_known() -> None:
    assert level(OPEN, f"to_bool({SIM})", "false") == "warning"
    assert level(f"{SHORT}\n\n\n{OPEN}", f"to_bool({SIM})", "false") == "warning"
    assert level(SHORT, f"other({SIM})", "false") == "warning"
    assert level("", f"ast.literal_eval({SIM})", "robot") == "warning"
