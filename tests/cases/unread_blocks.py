"""Blocks of parameter files that no node reads: of nodes that nobody starts, or that are not given the file."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

BUILD = CMAKE.replace(
    "ament_package",
    "add_executable(talker src/talker.cpp)\nadd_executable(other src/other.cpp)\n"
    "install(TARGETS talker other DESTINATION lib/${PROJECT_NAME})\n"
    "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package",
)
CODE = """\
#include <rclcpp/rclcpp.hpp>
class Talker : public rclcpp::Node {
public:
  Talker() : Node("talker") {
    declare_parameter<std::string>("port");
    declare_parameter("rate", 1.0);
    declare_parameter("global_frame", "map");
  }
};
int main() {return 0;}
"""
VALUES = """\
talker:
  ros__parameters:
    port: a
    rate: 5
    global_flame: odom
    names: []
    names: []
    depth: 1
    depth: 2
"""
NAV = """\
controller_server:
  ros__parameters:
    controller_frequency: 20
    controller_plugins: [FollowPath, Gone]
    FollowPath: {plugin: "dwb_core::DWBLocalPlanner"}
bt_navigator:
  ros__parameters:
    global_flame: odom
    robot_base_frame: base_link
    odom_topic: odom
local_costmap:
  ros__parameters:
    plugins: []
global_costmap:
  global_costmap:
    ros__parameters:
      plugins: []
planner_server:
  ros__parameters:
    planner_plugins: [GridBased, Gone]
    GridBased: {plugin: "nav2_navfn_planner::NavfnPlanner"}
"""
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    arm: {type: joint_trajectory_controller/JointTrajectoryController}
arms:
  ros__parameters: {joints: [a]}
"""
LAUNCH = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    config = os.path.join(get_package_share_directory('my_pkg'), 'config', 'robot.yaml')
    one = Node({ONE})
    two = Node({TWO})
    return LaunchDescription([DeclareLaunchArgument('on', default_value='false'), {ADDED}])
"""
TALKER = "package='my_pkg', executable='talker', parameters=[config]"
OTHER = "package='my_pkg', executable='other', parameters=[config]"
SERVER = "package='nav2_{0}', executable='{0}_server', name='{0}_server', parameters=[config]"
CONTROLLER, PLANNER = SERVER.format("controller"), SERVER.format("planner")
NAVIGATOR = "package='nav2_bt_navigator', executable='bt_navigator', name='bt_navigator', parameters=[config]"
SPAWNER = "package='controller_manager', executable='spawner', arguments=['arms'{}]"
MANAGER = "package='controller_manager', executable='ros2_control_node', parameters=[config]"


def package(values: str, one: str, two: str, added: str = "one, two", **more: str) -> Example:
    """A package whose launch file makes two nodes, and starts some of them."""
    launch = LAUNCH.replace("{ONE}", one).replace("{TWO}", two).replace("{ADDED}", added)
    files = {
        "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
        "CMakeLists.txt": BUILD,
        "src/talker.cpp": CODE,
        "src/other.cpp": CODE.replace('Node("talker")', 'Node("other")').replace(
            '<std::string>("port")', '("port", 1)'
        ),
        "config/robot.yaml": values,
        "launch/a.launch.py": launch,
        **{name.replace("__", "/").replace("_DOT_", "."): text for name, text in more.items()},
    }
    return Example(on="ament_cmake", bad=files, good={})


def with_build(example: Example, old: str, new: str) -> Example:
    return Example(on="ament_cmake", bad={**example.bad, "CMakeLists.txt": BUILD.replace(old, new)}, good={})


SECOND = LAUNCH.replace("{ONE}", TALKER).replace("{TWO}", OTHER).replace("{ADDED}", "one")
LISTENER = "package='my_pkg', executable='listener', parameters=[config]"
TO_SPAWNER = "package='controller_manager', executable='spawner', arguments=['--param-file', config]"


def of_own(values: str) -> tuple[Example, ...]:
    """Nodes of the package itself, which it starts, or does not start, with a file."""
    return (
        package(values, TALKER, OTHER),
        package(values, TALKER, OTHER, "two"),
        package(values, TALKER, OTHER, "two", launch__b_DOT_launch_DOT_py=SECOND),
        package(values, TALKER + ", condition=IfCondition(LaunchConfiguration('on'))", OTHER),
        package(values, TALKER, LISTENER, "two"),
        package(values.replace("talker", "/**"), TALKER, OTHER, "two"),
        package(values, OTHER, OTHER.replace("parameters=[config]", "name='a'")),
        package(values, OTHER, TO_SPAWNER),
        with_build(package(values, TALKER, OTHER), "DIRECTORY config launch", "DIRECTORY config"),
    )


def beside(launch: str) -> Example:
    """The package, which gives its file to one node, beside another one with a launch file."""
    own = package(VALUES.partition("    names")[0], OTHER, OTHER).bad
    more = {
        "package.xml": manifest("  <exec_depend>my_pkg</exec_depend>\n", "ament_cmake").replace("my_pkg</n", "b</n")
    }
    more |= {"CMakeLists.txt": CMAKE.replace("my_pkg", "b"), "launch/b.launch.py": launch}
    files = {f"my_pkg/{path}": text for path, text in own.items()} | {f"b/{path}": text for path, text in more.items()}
    return Example(on="", bad=files, good={})


BESIDE = (beside(SECOND), beside(SECOND.replace("'robot.yaml'", "'robots.yaml'")))
DOUBLED = of_own(VALUES)
MISTYPED = of_own(VALUES.partition("    names")[0])
NAVIGATION = (
    package(NAV, CONTROLLER, PLANNER),
    package(NAV, CONTROLLER, PLANNER, "one"),
    package(NAV, CONTROLLER, PLANNER, "two"),
    package(NAV, CONTROLLER, NAVIGATOR),
    package(NAV, CONTROLLER, NAVIGATOR, ""),
    package(NAV, CONTROLLER.replace("name='controller_server', ", ""), PLANNER, "one"),
)
CONTROL = tuple(
    package(CONTROLLERS, MANAGER, SPAWNER.format(more), added)
    for more, added in (("", "one, two"), ("", "one"), ("", ""), (", '--param-file', config", "two"))
)
NEEDED = tuple(
    package(VALUES, TALKER.replace("[config]", "[{'rate': 1.0}]"), "package='nav2_map_server', executable='map_server'")
    if not build
    else with_build(
        package(VALUES, TALKER.replace("[config]", "[]"), "package='nav2_map_server', executable='map_server'"), *build
    )
    for build in ((), ("DIRECTORY config launch", "DIRECTORY config"))
)
UNADDED = package(VALUES, TALKER.replace("[config]", "[]"), OTHER, "two")

CASES = {
    "PRM002": DOUBLED,
    "PRM003": (*DOUBLED, *NAVIGATION, *CONTROL, *BESIDE),
    "PRM004": (*DOUBLED, *NAVIGATION),
    "PRM006": (*MISTYPED, *NAVIGATION, *BESIDE),
    "PRM007": (*MISTYPED, *NAVIGATION),
    "PRM008": (*NAVIGATION, *NEEDED, UNADDED),
}
