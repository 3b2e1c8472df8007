"""What only older distributions had bites somebody only where the repository is shown to be for later ones."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    return LaunchDescription([{}])
"""
OLD = {
    "LCH002": "Node(package='controller_manager', executable='spawner.py')",
    "LCH005": "Node(package='controller_manager', node_executable='spawner')",
    "LCH011": "ComposableNodeContainer(name='a', namespace='', package='rclcpp_components', "
    "executable='component_container', composable_node_descriptions=[ComposableNode(package='moveit_servo', "
    "plugin='moveit_servo::ServoServer')])",
}
WORST = {"LCH002": "warning", "LCH005": "error", "LCH011": "warning"}


INSTALL = "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n"


def level(code: str, more: dict[str, str], targets: tuple[str, ...] = ()) -> str:
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{INSTALL}ament_package"),
        "launch/a.launch.py": LAUNCH.format(OLD[code]),
    }
    (found,) = lint_files({**files, **more}, [code], targets).findings
    return found.severity.value


@pytest.mark.parametrize("code", OLD)
@pytest.mark.parametrize(
    "more",
    [
        {},
        {"README.md": "A robot.\n"},
        {"README.md": "For ROS 2 Foxy.\n"},
        {"README.md": "For ROS 2 Foxy, Humble and Jazzy.\n"},
        {".github/workflows/ci.yml": "matrix: {distro: [foxy, humble]}\n"},
    ],
)
def test_names_of_distributions_that_may_be_meant_are_infos(code: str, more: dict[str, str]) -> None:
    assert level(code, more) == "info"


@pytest.mark.parametrize("code", OLD)
@pytest.mark.parametrize(
    "more",
    [
        {"README.md": "For ROS 2 Humble or Jazzy.\n"},
        {"Dockerfile": "FROM ros:jazzy\n"},
        {".github/workflows/ci.yml": "matrix: {distro: [humble, rolling]}\n"},
    ],
)
def test_names_that_the_distributions_that_are_meant_lack(code: str, more: dict[str, str]) -> None:
    assert level(code, more) == WORST[code]


@pytest.mark.parametrize("code", OLD)
def test_a_target_is_meant(code: str) -> None:
    assert level(code, {}, ("jazzy",)) == WORST[code]
