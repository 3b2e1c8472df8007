"""Dependencies that stand for others: nobody declares the one without using the others through it.

Source: the manifests of ament/ament_cmake, ament/ament_lint, ros2/launch, ros2/launch_ros and ros2/ros_testing.  What a
node imports when it runs is not among them: a direct use is to be declared.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

LAUNCH = frozenset({"launch", "launch_ros", "launch_xml", "launch_yaml", "ament_index_python"})
"""What a launch file is made of; `ros2launch` brings it all."""

IN_LAUNCH_FILES: Mapping[str, frozenset[str]] = {
    "ros2launch": LAUNCH,
    "launch_ros": frozenset({"launch", "rclpy", "python3-yaml", "ament_index_python"}),
    "launch_xml": frozenset({"launch"}),
    "launch_yaml": frozenset({"launch"}),
}

IN_TESTS: Mapping[str, frozenset[str]] = {
    **IN_LAUNCH_FILES,
    "launch_testing": frozenset({"launch", "launch_xml", "launch_yaml", "ament_index_python", "python3-pytest"}),
    "launch_testing_ament_cmake": frozenset({"launch_testing"}),
    "launch_testing_ros": frozenset({"launch_testing", "launch_ros", "rclpy"}),
    "launch_pytest": frozenset({"launch_testing"}),
    "ros_testing": frozenset({"launch_testing", "launch_testing_ament_cmake", "launch_testing_ros", "ros2test"}),
    "ament_cmake_pytest": frozenset({"python3-pytest"}),
    "ament_lint_common": frozenset(
        {"ament_copyright", "ament_cppcheck", "ament_cpplint", "ament_flake8", "ament_lint_cmake", "ament_pep257"}
        | {"ament_uncrustify", "ament_xmllint"}
    ),
}


AMENT_CMAKE = frozenset(
    "ament_cmake_core ament_cmake_export_definitions ament_cmake_export_dependencies"
    " ament_cmake_export_include_directories ament_cmake_export_interfaces ament_cmake_export_libraries"
    " ament_cmake_export_link_flags ament_cmake_export_targets ament_cmake_gen_version_h"
    " ament_cmake_include_directories ament_cmake_libraries ament_cmake_python ament_cmake_target_dependencies"
    " ament_cmake_test ament_cmake_version".split()
)

IN_CMAKE: Mapping[str, frozenset[str]] = {
    "ament_cmake": AMENT_CMAKE,
    "ament_cmake_google_benchmark": frozenset({"google_benchmark_vendor"}),
    "ament_cmake_auto": frozenset({"ament_cmake", "ament_cmake_gmock", "ament_cmake_gtest"}),
    "ament_cmake_ros": frozenset({"ament_cmake", "ament_cmake_gmock", "ament_cmake_gtest", "ament_cmake_pytest"}),
    "ament_cmake_ros_core": frozenset({"ament_cmake"}),
    "ament_lint_auto": frozenset({"ament_cmake_test"}),
    "ament_lint_common": frozenset(
        {"ament_cmake_copyright", "ament_cmake_cppcheck", "ament_cmake_cpplint", "ament_cmake_flake8"}
        | {"ament_cmake_lint_cmake", "ament_cmake_pep257", "ament_cmake_uncrustify", "ament_cmake_xmllint"}
    ),
    "rosidl_default_generators": frozenset({"rosidl_cmake"}),
}
"""Build tools that find others for whoever finds them."""


IN_SOURCES: Mapping[str, frozenset[str]] = {
    "pluginlib": frozenset({"class_loader"}),
    "rclcpp_components": frozenset({"class_loader", "rclcpp"}),
    "cv_bridge": frozenset({"libopencv-dev"}),
}
"""What C++ includes because macros and headers of another package ask for it."""


NAVIGATION = frozenset(
    "costmap_queue dwb_core dwb_critics dwb_msgs dwb_plugins nav2_amcl nav2_behavior_tree nav2_behaviors"
    " nav2_bt_navigator nav2_collision_monitor nav2_constrained_smoother nav2_controller nav2_core nav2_costmap_2d"
    " nav2_dwb_controller nav2_graceful_controller nav2_lifecycle_manager nav2_map_server nav2_mppi_controller"
    " nav2_navfn_planner nav2_planner nav2_regulated_pure_pursuit_controller nav2_rotation_shim_controller nav2_route"
    " nav2_rviz_plugins nav2_simple_commander nav2_smac_planner nav2_smoother nav2_theta_star_planner"
    " nav2_velocity_smoother nav2_waypoint_follower opennav_docking".split()
)
MOVE_GROUP = frozenset({"moveit_core", "moveit_kinematics", "moveit_ros_planning"})
MOVEIT = MOVE_GROUP | frozenset(
    "moveit_planners_chomp moveit_planners_ompl moveit_planners_stomp moveit_ros_move_group moveit_ros_perception"
    " moveit_ros_visualization moveit_simple_controller_manager pilz_industrial_motion_planner".split()
)
CONTROLLERS = frozenset(
    "ackermann_steering_controller admittance_controller bicycle_steering_controller chained_filter_controller"
    " diff_drive_controller effort_controllers force_torque_sensor_broadcaster forward_command_controller"
    " gpio_controllers gps_sensor_broadcaster gripper_controllers imu_sensor_broadcaster joint_state_broadcaster"
    " joint_trajectory_controller mecanum_drive_controller motion_primitives_controllers"
    " omni_wheel_drive_controller parallel_gripper_controller pid_controller pose_broadcaster position_controllers"
    " range_sensor_broadcaster state_interfaces_broadcaster steering_controllers_library"
    " tricycle_controller tricycle_steering_controller vda5050_safety_state_broadcaster velocity_controllers".split()
)

IN_PARAMETERS: Mapping[str, frozenset[str]] = {
    "moveit": MOVEIT,
    "moveit_planners": frozenset({"moveit_planners_chomp", "moveit_planners_ompl", "moveit_planners_stomp"})
    | {"pilz_industrial_motion_planner"},
    "moveit_plugins": frozenset({"moveit_simple_controller_manager"}),
    "moveit_ros": MOVE_GROUP | {"moveit_ros_perception", "moveit_ros_visualization"},
    "moveit_ros_move_group": MOVE_GROUP,
    "nav2_bringup": NAVIGATION,
    "nav2_dwb_controller": frozenset({"costmap_queue", "dwb_core", "dwb_critics", "dwb_msgs", "dwb_plugins"}),
    "navigation2": NAVIGATION,
    "ros2_control": frozenset({"controller_interface", "controller_manager", "hardware_interface"}),
    "ros2_controllers": CONTROLLERS,
    "controller_manager": frozenset({"controller_interface", "hardware_interface"}),
}
"""What comes with a package for whoever names plug-ins in parameters, by the manifests of ros-navigation, moveit and
ros-controls."""


def implied_by(names: Iterable[str], table: Mapping[str, frozenset[str]]) -> frozenset[str]:
    """Return what some dependencies stand for, by one of the tables."""
    found: set[str] = set()
    waiting = list(names)
    while waiting:
        new = table.get(waiting.pop(), frozenset()) - found
        found |= new
        waiting += new
    return frozenset(found)
