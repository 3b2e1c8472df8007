"""Two packages in which every kind of name leads somewhere."""

from __future__ import annotations

from rospkg_cli.example import SETUP_PY_FOR_ALL, Example

MANIFEST = Example(bad={}, good={}).bad_files()["package.xml"]
CMAKE_MANIFEST = MANIFEST.replace("my_pkg", "my_cpp").replace("ament_python", "ament_cmake")
FILES = {
    **{f"my_pkg/{path}": text for path, text in Example(bad={}, good={}).bad_files().items()},
    "my_pkg/package.xml": MANIFEST.replace(
        "<export>", "<depend>my_cpp</depend><depend>rclpy</depend><depend>libopencv-dev</depend><export>"
    ),
    "my_pkg/setup.py": SETUP_PY_FOR_ALL.replace(
        "    license=", "    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},\n    license="
    ),
    "my_pkg/launch/b.launch.py": """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('mode', default_value='fast'),
        IncludeLaunchDescription(
            os.path.join(get_package_share_directory('my_cpp'), 'launch', 'c.launch.xml'),
            launch_arguments={'rate': LaunchConfiguration('mode')}.items(),
        ),
        Node(package='my_cpp', executable='driver', parameters=[{'speed': 1.0}]),
    ])
""",
    "my_cpp/launch/c.launch.xml": """\
<launch>
  <arg name="rate" default="1"/>
  <arg name="radius" default="2"/>
  <node pkg="my_cpp" exec="driver">
    <param name="speed" value="$(var rate)"/>
    <param name="size" value="$(var radius)"/>
  </node>
</launch>
""",
    "my_pkg/my_pkg/talker.py": "import rclpy\n\n\nasync def main():\n    pass\n",
    "my_pkg/launch/a.launch.xml": """\
<launch>
  <arg name="speed" default="1"/>
  <node pkg="my_pkg" exec="talker" name="$(var speed)"/>
  <node pkg="my_cpp" exec="driver">
    <param from="$(find-pkg-share my_cpp)/config/p.yaml"/>
  </node>
  <node_container pkg="rclcpp_components" exec="component_container" name="c" namespace="">
    <composable_node pkg="my_cpp" plugin="mine::Driver"/>
  </node_container>
</launch>
""",
    "my_cpp/package.xml": CMAKE_MANIFEST,
    "my_cpp/CMakeLists.txt": """\
project(my_cpp)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
add_executable(driver src/driver.cpp)
add_library(parts SHARED src/parts.cpp)
rclcpp_components_register_nodes(parts "mine::Driver")
rosidl_generate_interfaces(${PROJECT_NAME} "msg/Status.msg" "msg/Robot.msg")
install(TARGETS driver DESTINATION lib/${PROJECT_NAME})
install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})
ament_package()
""",
    "my_cpp/src/driver.cpp": "// the driver\nint main() {}\n",
    "my_cpp/src/parts.cpp": """\
namespace mine { class Driver {
  Driver() { declare_parameter<double>("speed", 1.0); } }; }
""",
    "my_cpp/config/p.yaml": "driver:\n  ros__parameters:\n    speed: 2.0\n",
    "my_cpp/msg/Status.msg": "float32 battery\n",
    "my_cpp/msg/Robot.msg": "Status status\nstd_msgs/Header header  # rospkg: ignore[IDL004] because\n",
    "my_cpp/urdf/r.urdf": '<robot name="r"><link name="l"><visual><geometry>\n'
    '<mesh filename="package://my_cpp/config/p.yaml"/></geometry></visual></link></robot>\n',
}  # fmt: skip
