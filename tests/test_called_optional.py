"""What a page or a script of the repository calls optional is an info where a launch file needs it undeclared."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest, scripts, setup_py
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


LISTS = """\
# Robot

## Optional

- foxglove_bridge

## Needed

- mavros
"""
LABEL = "# Robot\n\nOptional dependencies:\n\n    sudo apt install ros-humble-foxglove-bridge\n\nThen install mavros.\n"
BLOCK = """\
### Optional dependencies

```bash
sudo apt install \\
  ros-$ROS_DISTRO-foxglove-bridge
```

### Install

```bash
sudo apt install ros-$ROS_DISTRO-mavros
```
"""


@pytest.mark.parametrize("page", [LISTS, LABEL, BLOCK])
def test_a_list_below_a_heading(page: str) -> None:
    assert level("foxglove_bridge", README_DOT_md=page) == "info"
    assert level("mavros", README_DOT_md=page) == "warning"


def test_arguments_and_prose_below_a_heading() -> None:
    assert level("mavros", README_DOT_md="## Optional arguments\n\n- mavros\n") == "warning"
    assert level("mavros", README_DOT_md="## Optional\n\nThe drone flies with mavros.\n") == "warning"


def levels(code: str, files: dict[str, str]) -> list[str]:
    return [each.severity.value for each in lint_files(files, [code]).findings]


def test_comments_of_the_manifest_and_of_the_file() -> None:
    launch, xml = LAUNCH.format("mavros"), '<launch>\n  <node pkg="mavros" exec="mavros_node"/>\n</launch>\n'
    plain = {"package.xml": manifest(NEEDS), "launch/robot.launch.py": launch}
    said = manifest(f"  <!-- mavros is optional: only the drone has it -->\n{NEEDS}")
    assert levels("DEP103", plain) == ["warning"]
    assert levels("DEP103", {**plain, "package.xml": said}) == ["info"]
    for comment, expected in (("# Optional: mavros", "info"), ("# mavros, and an optional camera=1", "info")):
        changed = launch.replace("    return", f"    {comment}\n    return")
        assert levels("DEP103", {**plain, "launch/robot.launch.py": changed}) == [expected]
    for comment, expected in (("<!-- optional: mavros -->", "info"), ("<!-- the camera is optional -->", "warning")):
        files = {"package.xml": manifest(""), "launch/robot.launch.xml": xml.replace("<launch>", f"<launch>{comment}")}
        assert levels("DEP103", files) == [expected]


@pytest.mark.parametrize(
    ("module", "line", "expected"),
    [
        ("cv2", "- OpenCV (optional)", "info"),
        ("serial", "pyserial is only needed for the real robot", "info"),
        ("serial", "A serial port is optional", "warning"),
        ("foxglove_msgs.msg", "- `foxglove_msgs` (optional)", "info"),
        ("foxglove_msgs.msg", "- `foxglove_msgs`", "warning"),
    ],
)
def test_imports(module: str, line: str, expected: str) -> None:
    files = {"package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"), "README.md": f"# Robot\n\n{line}\n"}
    files |= {"setup.py": setup_py(scripts("talker = my_pkg.talker:main")), "my_pkg/__init__.py": ""}
    module = f"import rclpy\nimport {module}\n\n\ndef main():\n    rclpy.init()\n"
    assert levels("DEP101", {**files, "my_pkg/talker.py": module}) == [expected]


@pytest.mark.parametrize(("line", "expected"), [("nav2_bringup (optional)", "info"), ("nav2_bringup", "warning")])
def test_look_ups(line: str, expected: str) -> None:
    files = {"package.xml": manifest("  <exec_depend>ament_index_python</exec_depend>\n"), "README.md": f"- {line}\n"}
    files |= {"setup.py": setup_py(scripts("talker = my_pkg.talker:main")), "my_pkg/__init__.py": ""}
    module = "from ament_index_python.packages import get_package_share_directory\n\n\ndef main():\n"
    module += "    print(get_package_share_directory('nav2_bringup'))\n"
    assert levels("DEP116", {**files, "my_pkg/talker.py": module}) == [expected]


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


@pytest.mark.parametrize(
    ("page", "comment", "expected"),
    [
        ("- ur_description (optional)\n", "", "info"),
        ("- ur_description\n", "<!-- optional: ur_description -->", "info"),
        ("- ur_description\n", "<!-- optional: the gripper -->", "warning"),
    ],
)
def test_robots(page: str, comment: str, expected: str) -> None:
    robot = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">{}\n'
    robot += (
        '  <xacro:include filename="$(find ur_description)/urdf/ur_macro.xacro"/>\n  <link name="base"/>\n</robot>\n'
    )
    files = {"package.xml": manifest(""), "README.md": f"    xacro urdf/robot.urdf.xacro > robot.urdf\n\n{page}"}
    assert levels("DEP106", {**files, "urdf/robot.urdf.xacro": robot.format(comment)}) == [expected]
