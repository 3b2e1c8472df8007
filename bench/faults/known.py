"""What can be known without a checkout of it: a fault in other names is excluded."""

from __future__ import annotations

from bench.faults.source_package import SourcePackage

WELL_KNOWN = set(
    "tf2_ros robot_state_publisher joint_state_publisher joint_state_publisher_gui rviz2 controller_manager xacro joy "
    "ros_gz_sim ros_gz_bridge gazebo_ros image_proc depth_image_proc image_view teleop_twist_joy twist_mux "
    "slam_toolbox nav2_map_server nav2_amcl nav2_planner nav2_controller nav2_bt_navigator nav2_lifecycle_manager "
    "nav2_behaviors nav2_velocity_smoother moveit_ros_move_group robot_localization rqt_gui demo_nodes_cpp "
    "demo_nodes_py rclcpp_components rosbridge_server usb_cam composition pointcloud_to_laserscan".split()
)
"""Packages outside a repository whose executables and components every user knows."""
INTERFACES = set(
    "action_msgs actionlib_msgs builtin_interfaces composition_interfaces diagnostic_msgs example_interfaces "
    "geometry_msgs lifecycle_msgs nav_msgs rcl_interfaces rosgraph_msgs sensor_msgs shape_msgs std_msgs std_srvs "
    "stereo_msgs tf2_msgs trajectory_msgs unique_identifier_msgs visualization_msgs nav2_msgs control_msgs "
    "moveit_msgs controller_manager_msgs test_msgs".split()
)
"""Packages whose interfaces are known without a checkout of them."""
UNKNOWN = "the interfaces of a package that is not here, and in no table"


def has_known_interfaces(package: SourcePackage, name: str) -> bool:
    return name in INTERFACES or name in package.siblings


def is_in_repository(package: SourcePackage, name: str, but: str = "") -> bool:
    """Return whether a file of that name is there, other than the one that names it."""
    return any(each != package.repository / but for each in package.repository.rglob(name))
