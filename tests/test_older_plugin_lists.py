"""Lists of plugins for distributions before Humble, which nav2 read otherwise: what they lack is an info (PRM008)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.testing import lint_files

NAV = (
    "controller_server:\n  ros__parameters:\n    goal_checker_plugins: [general_goal_checker]\n    goal_checker:\n"
    "      plugin: nav2_controller::SimpleGoalChecker\n"
)
LAUNCH = '<launch>\n  <arg name="params" default="config/nav.yaml"/>\n</launch>\n'
COMMAND = "ros2 launch nav2_bringup bringup_launch.py params_file:=config/nav.yaml\n"
BOTH = {"README.md": "For ROS 2 Humble.\n", "docs/robot.md": f"source /opt/ros/foxy/setup.bash\n{COMMAND}"}


@pytest.mark.parametrize(
    ("pages", "level"),
    [
        ({}, "warning"),
        ({"README.md": "For ROS 2 Humble.\n"}, "warning"),
        ({"README.md": f"source /opt/ros/humble/setup.bash\n{COMMAND}"}, "warning"),
        ({"README.md": "For ROS 2 Foxy.\n"}, "info"),
        (BOTH, "info"),
        ({**BOTH, "launch/nav.launch.xml": LAUNCH}, "warning"),
    ],
)
def test_what_a_list_for_an_older_distribution_lacks(pages: dict[str, str], level: str) -> None:
    files = {
        **existing_files(BACKDROPS["config"]),
        "config/nav.yaml": NAV,
        "package.xml": manifest("  <exec_depend>nav2_controller</exec_depend>\n", "ament_cmake"),
        **pages,
    }
    (found,) = lint_files(files, ["PRM008"]).findings
    assert found.severity.value == level
