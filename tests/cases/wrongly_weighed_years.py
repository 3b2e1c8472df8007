"""For which distribution a package is where no README, script or workflow says it: other pages, and its own words."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest

SPAWNER = '<launch>\n  <node pkg="controller_manager" exec="spawner.py" args="arm"/>\n</launch>\n'
PYTHON = """\
{}
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='controller_manager', executable='spawner.py', arguments=['arm'])])
"""
OLD = """\
from launch import LaunchDescription
from launch_ros.actions import {0}


def generate_launch_description():
    return LaunchDescription([{0}(package='my_pkg', {1})])
"""
CONVERT = """\
<launch>
  <node_container pkg="rclcpp_components" exec="component_container" name="c" namespace="">
    <composable_node pkg="velodyne_pointcloud" plugin="velodyne_pointcloud::Convert" name="convert"/>
  </node_container>
</launch>
"""
DESCRIBED = manifest().replace("<description>", "<description>For Foxy. ")
PAGE = "doc/arm.md"
BOTH = {"README.md": "On the robot: Foxy.\n", "scripts/laptop.sh": "source /opt/ros/humble/setup.bash\n"}


def spawning(pages: dict[str, str], own: dict[str, str] | None = None) -> Example:
    """A package that starts what Foxy had, below pages."""
    mine = {"package.xml": manifest(), "launch/a.launch.xml": SPAWNER, **(own or {})}
    return Example(on="", good={}, bad={**{f"src/my_pkg/{path}": text for path, text in mine.items()}, **pages})


def launched(docstring: str, pages: dict[str, str]) -> Example:
    own = {"launch/a.launch.xml": "<launch/>\n", "launch/b.launch.py": PYTHON.format(docstring)}
    return spawning(pages, own)


CASES = {
    "LCH002": (
        spawning({PAGE: "### ROS2 Foxy\n"}),
        spawning({PAGE: "### ROS2 Foxy\n", "docs/more/laptop.md": "apt install ros-humble-desktop\n"}),
        spawning({PAGE: "Foxy; a humble soldering iron, and https://docs.ros.org/en/ros2_packages/rolling/api/a\n"}),
        spawning({PAGE: "Foxy: https://github.com/ros-controls/ros2_control/tree/humble\n"}),
        spawning({PAGE: "On ROS 2 Galactic.\n"}),
        spawning({PAGE: "A map of galactic size.\n"}),
        spawning({"CHANGELOG.md": "Ported to Foxy.\n"}),
        spawning({}, {"CONTRIBUTING.md": "Test on Foxy.\n"}),
        spawning({}, {"config/nav2_foxy.yaml": ""}),
        spawning({}, {"config/nav2_galactic.yaml": ""}),
        spawning({}, {"config/nav2_foxy.yaml": "", "config/nav2.yaml": ""}),
        spawning({}, {"config/nav2_foxy.yaml": "", "config/nav2_humble.yaml": ""}),
        spawning({}, {"package.xml": DESCRIBED}),
        spawning(BOTH),
        spawning(BOTH, {"package.xml": DESCRIBED}),
        spawning({"README.md": "For Humble.\n"}, {"package.xml": DESCRIBED}),
        launched('"""Starts the arm on Foxy."""', {}),
        launched('"""Starts the arm on Foxy."""', BOTH),
        launched("# Foxy alone", {}),
        launched("# Foxy alone", BOTH),
    ),
    "LCH005": (spawning({PAGE: "Foxy\n"}, {"launch/b.launch.py": OLD.format("Node", "node_executable='a'")}),),
    "LCH011": (spawning({PAGE: "Foxy\n"}, {"launch/a.launch.xml": CONVERT}),),
    "LCH014": (
        spawning({PAGE: "Foxy\n"}, {"launch/b.launch.py": OLD.format("LifecycleNode", "executable='a', name='a'")}),
    ),
}
