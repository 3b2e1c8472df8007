"""What never comes to the node, the launch or the robot, and what is for older distributions alone."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest, scripts, setup_py

from .idle_parameters import below
from .shown_params import INSTALLED

NAV2 = """\
controller_server:
  ros__parameters:
    controller_frequency: 20.0
planner_server:
  ros__parameters:
    expected_planner_frequency: 20.0
bt_navigator:
  ros__parameters:
    global_frame: map
global_costmap:
  global_costmap:
    ros__parameters:
      width: 0.5
local_costmap:
  ros__parameters:
    width: 0.5
"""


def costmaps(text: str = NAV2) -> Example:
    return Example(bad={"config/nav2.yaml": text}, good={}, on="config")


PRINTED = """\
import logging

from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    path = LaunchConfiguration('path')
    print(str(path), 'is the path')
    logging.getLogger().info(f'the path is {path}')
    return LaunchDescription([ExecuteProcess(cmd=['ls', str(path)])])
"""


CONTAINER = """\
<launch>
  <node_container pkg="rclcpp_components" exec="component_container" name="c" namespace="">
    <composable_node pkg="velodyne_pointcloud" plugin="velodyne_pointcloud::Convert" name="convert"/>
  </node_container>
  <node pkg="velodyne_pointcloud" exec="velodyne_convert_node"/>
</launch>
"""
BRANCHES = "This master branch is developed based on `{}`.\n- foxy\n- galactic\n- humble\n"
PAGES = ("For Foxy.\n", "For Humble.\n", BRANCHES.format("foxy"), BRANCHES.format("humble"))
NEEDING = ("velodyne_monitor", "velodyne_driver", "other_monitor")
LOADED = (
    *(below(page, {"launch/a.launch.xml": CONTAINER}) for page in PAGES),
    *(
        Example(
            bad={"package.xml": manifest(f"  <exec_depend>{name}</exec_depend>\n"), "launch/a.launch.xml": CONTAINER},
            good={},
        )
        for name in NEEDING
    ),
)
READS = """\
#include <rclcpp/rclcpp.hpp>

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("talker");
  std::string port = "a";
  node->get_parameter("port", port);
}
"""


OWN_DEFAULT = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">
  <xacro:arg name="model" default="$(arg model)"/>
  <link name="$(arg model)_base"/>
</robot>
"""
COMMANDS = (
    "xacro $(find-pkg-share my_pkg)/config/robot.urdf.xacro",
    "xacro $(find-pkg-share my_pkg)/config/robot.urdf.xacro model:=a",
    "",
)
SHOWS = '<launch>\n  <let name="robot" value="$(command \'{}\')"/>\n</launch>\n'


MESHED = """\
<robot name="arm">
  <link name="base">
    <visual><geometry><mesh filename="package://my_pkg/meshes/base.stl"/></geometry></visual>
  </link>
</robot>
"""
OPENS = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import LogInfo


def generate_launch_description():
    path = os.path.join(get_package_share_directory('my_pkg'), {})
    return LaunchDescription([LogInfo(msg=open(path).read())])
"""
BESIDE = INSTALLED.replace("DIRECTORY config", "DIRECTORY launch models urdf")


def robots(path: str, other: str, named: str) -> Example:
    """A robot that lacks its mesh, beside another robot; a launch file opens one of them."""
    files = {path: MESHED, other: '<robot name="arm"><link name="base"/></robot>\n'}
    return Example(
        bad={"CMakeLists.txt": BESIDE, **files, "launch/a.launch.py": OPENS.format(named)}, good={}, on="ament_cmake"
    )


UNUSED = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    config = '/home/ada/ws/src/my_pkg/config/robot.yaml'
    spawner = Node(package='controller_manager', executable='spawner', arguments=['arm', '--param-file', config])
    return LaunchDescription([{}])
"""
LEFT = """\
controller_manager:
  ros__parameters:
    arm:
      type: joint_trajectory_controller/JointTrajectoryController
    {}force:
    {}  type: admittance_controller/AdmittanceController
force:
  ros__parameters:
    kinematics:
      plugin_name: kinematics_interface_kdl/KinematicsInterfaceKDL
local_costmap:
  local_costmap:
    ros__parameters:
      plugins: [{}]
      grid_layer:
        plugin: spatio_temporal_voxel_layer/SpatioTemporalVoxelLayer
"""
NEEDED = "".join(
    f"  <exec_depend>{name}</exec_depend>\n"
    for name in ("controller_manager", "joint_trajectory_controller", "admittance_controller")
)
SPAWNING = """\
<launch>
  <node pkg="controller_manager" exec="ros2_control_node">
    <param from="$(find-pkg-share my_pkg)/config/robot.yaml"/>
  </node>
</launch>
"""


def plugged(sign: str, listed: str) -> Example:
    return Example(
        bad={
            "package.xml": manifest(NEEDED, "ament_cmake"),
            "config/robot.yaml": LEFT.format(sign, sign, listed),
            "launch/a.launch.xml": SPAWNING,
        },
        good={},
        on="config",
    )


CONTROLLED = """\
<robot name="arm">
  <link name="base"/>
  <ros2_control name="arm" type="system"><joint name="elbow"/></ros2_control>
</robot>
"""


MANAGER = "ros2 run controller_manager ros2_control_node\n"
CHOSEN = """\
import os

from ament_index_python.packages import get_package_share_directory

if os.environ['ROS_DISTRO'] == 'humble':
    print(get_package_share_directory('ros_ign_gazebo'))
else:
    print(get_package_share_directory('{}'))
"""


CASES = {
    "DEP116": tuple(
        Example(
            bad={
                "package.xml": manifest("  <exec_depend>ament_index_python</exec_depend>\n"),
                "my_pkg/talker.py": CHOSEN.format(name),
                "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
            },
            good={},
        )
        for name in ("ros_gz_sim", "ros_ign_gazebo")
    ),
    "DEP106": (plugged("# ", ""), plugged("", "grid_layer")),
    "DEP118": tuple(
        Example(bad={"launch/a.launch.py": UNUSED.format(added), "config/robot.yaml": "arm:\n"}, good={})
        for added in ("", "spawner")
    ),
    "URD002": (
        robots("arm.urdf", "models/arm/arm.urdf", "'models', 'arm', 'arm.urdf'"),
        robots("models/arm/arm.urdf", "arm.urdf", "'models', 'arm', 'arm.urdf'"),
        robots("urdf/arm.absolute.urdf", "urdf/arm.urdf", "'urdf', 'arm.urdf'"),
        robots("urdf/arm.urdf", "urdf/arm.absolute.urdf", "'urdf', 'arm.urdf'"),
        robots("urdf/arm.absolute.urdf", "urdf/arm.urdf", "'urdf', 'arm' + '.absolute.urdf'"),
    ),
    "URD001": (
        *(
            Example(
                bad={"config/robot.urdf.xacro": OWN_DEFAULT, "launch/a.launch.xml": SHOWS.format(command)},
                good={},
                on="config",
            )
            for command in COMMANDS
        ),
        *(
            below(page, {"urdf/arm.urdf": CONTROLLED, "start.sh": MANAGER})
            for page in ("Humble\n", "Humble, Jazzy\n", "")
        ),
    ),
    "LCH002": LOADED,
    "LCH011": LOADED,
    "PRM007": (
        Example(
            bad={
                "src/my_pkg/package.xml": manifest("", "ament_cmake"),
                "src/my_pkg/README.md": "ROS2 Crystal\n",
                "src/my_pkg/src/talker.cpp": READS,
            },
            good={},
            on="",
        ),
        *(below(page, {"src/talker.cpp": READS}) for page in ("ROS 2 Crystal, Humble\n", "Crystal clear\n")),
    ),
    "LCH014": (Example(bad={"launch/a.launch.py": PRINTED}, good={}),),
    "PRM003": (
        costmaps(),
        costmaps(NAV2.replace("bt_navigator", "local_costmap/local_costmap")),
        costmaps(NAV2.replace("controller_server", "smoother_server")),
        costmaps(NAV2.replace("    width: 0.5\n", "    width: 5.0\n    robot_base_frame: base_link\n")),
        costmaps(NAV2.replace("    width: 0.5\n", "    width: 5.0\n    plugins: [a]\n")),
    ),
    "PRM006": (costmaps(),),
}
