"""What a page or a script of the repository calls optional is an info where a launch file needs it undeclared."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='{0}', executable='{0}_node')])
"""
NEEDS = "  <exec_depend>ros2launch</exec_depend>\n"


def level(package: str, **pages: str) -> str:
    files = {
        "package.xml": manifest(NEEDS),
        "launch/robot.launch.py": LAUNCH.format(package),
        **{path.replace("__", "/").replace("_DOT_", "."): text for path, text in pages.items()},
    }
    (only,) = lint_files(files, ["DEP103"]).findings
    assert only.message.endswith("calls it optional") is (only.severity.value == "info")
    return only.severity.value


@pytest.mark.parametrize(
    ("package", "line"),
    [
        ("mavros", "**MAVROS** (`ros-*-mavros`) is opt-in: run `make drone-mavros`."),
        ("mavros", "## MAVROS (optional)"),
        ("mavros", "MAVROS is only needed for real flights."),
        ("ros_gz_bridge", "Gazebo is opt-in. This installs the `ros_gz` bridge."),
        ("realsense2_camera", "### Optional: RealSense D435i"),
        ("foxglove_bridge", "If you want to use Foxglove, install it:"),
        ("foxglove_bridge", "| Foxglove (optional) | `apt install ros-humble-foxglove-bridge` |"),
        ("mavros", "### 安装mavros（可选）"),
        ("mavros", "## MAVROS (opcional)"),
        ("velodyne_driver", "- `ros-humble-velodyne` (optional)"),
    ],
)
def test_a_package_that_a_page_calls_optional(package: str, line: str) -> None:
    assert level(package, README_DOT_md=f"# Robot\n\n{line}\n") == "info"
    assert level(package, README_DOT_md="# Robot\n", install_DOT_sh=f"# {line}\n") == "info"


@pytest.mark.parametrize(
    ("package", "line"),
    [
        ("mavros", "Install MAVROS."),
        ("mavros", "The camera is optional.\nMAVROS flies the drone."),
        ("mavros", "| `fcu_url` | where MAVROS connects | optional |"),
        ("mavros", "- `use_sim` (optional): starts MAVROS with the simulation"),
        ("mavros", "- `use_mavros:=true` (optional)"),
        ("mavros", "MAVROS takes these optional parameters:"),
        ("mavros", "mavros的可选参数"),
        ("mavros", "The topic /mavros/state is optional."),
        ("camera_ros", "A camera is optional."),
        ("robot_state_publisher", "A second robot is optional."),
        ("joy", "A joystick is optional."),
    ],
)
def test_what_is_not_called_optional(package: str, line: str) -> None:
    assert level(package, README_DOT_md=f"# Robot\n\n{line}\n") == "warning"


def test_a_page_of_another_package() -> None:
    own = {"my_pkg/package.xml": manifest(NEEDS), "my_pkg/launch/robot.launch.py": LAUNCH.format("mavros")}
    files = {**own, "other/package.xml": manifest("").replace("my_pkg", "other")}
    page = "MAVROS (optional)\n"
    for path, expected in (("other/README.md", "warning"), ("docs/setup.md", "info"), ("my_pkg/README.md", "info")):
        (only,) = lint_files({**files, path: page}, ["DEP103"]).findings
        assert only.severity.value == expected
