"""Files that a launch file opens in a helper which goes on with nothing where one is missing."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

LAUNCH = """\
import os
import yaml
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def load_yaml(package, path):
    full = os.path.join(get_package_share_directory(package), path)
{body}


def generate_launch_description():
    servo = load_yaml('my_pkg', 'config/servo.yaml')
    other = load_yaml('my_pkg', 'config/{name}')
    return LaunchDescription([Node(package='joy', executable='joy_node', parameters=[servo, other])])
"""
TRY = """\
    try:
        with open(full) as file:
            return yaml.safe_load(file)
    except OSError:
        {handler}
"""
PLAIN = "    with open(full) as file:\n        return yaml.safe_load(file)\n"
ASKED = "    if not os.path.exists(full):\n        return None\n" + TRY


@pytest.mark.parametrize(
    "body, name, levels",
    [
        (TRY.format(handler="return None"), "arm.yaml", ["info"]),
        (TRY.format(handler="return"), "arm.yaml", ["info"]),
        (TRY.format(handler="pass"), "arm.yaml", ["info"]),
        (TRY.format(handler="return None").replace("OSError", "EnvironmentError"), "arm.yaml", ["info"]),
        (TRY.format(handler="return None").replace(" OSError", ""), "arm.yaml", ["info"]),
        (TRY.format(handler="return None").replace("OSError", "yaml.YAMLError"), "arm.yaml", ["error"]),
        (TRY.format(handler="return {'rate': 1}"), "arm.yaml", []),
        (TRY.format(handler="return {}"), "arm.yaml", []),
        (TRY.format(handler="raise"), "arm.yaml", []),
        (ASKED.format(handler="return None"), "arm.yaml", []),
        (TRY.format(handler="return None"), "servo.yaml", []),
        (PLAIN, "arm.yaml", ["error"]),
    ],
)
def test_a_file_that_is_opened_by_a_helper(body: str, name: str, levels: list[str]) -> None:
    files = {
        "package.xml": manifest("  <exec_depend>joy</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", "install(DIRECTORY launch config DESTINATION share/${PROJECT_NAME})\nament_package"
        ),
        "config/servo.yaml": "rate: 1\n",
        "launch/a.launch.py": LAUNCH.format(body=body.rstrip(), name=name),
    }
    found = lint_files(files, ["LCH003"]).findings
    assert [each.severity.value for each in found] == levels
    assert all("config/arm.yaml" in each.message for each in found)
