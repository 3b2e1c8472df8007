"""What `bench.well_known` reads, and the renames that no similarity shows; the release notes of each repository."""

from __future__ import annotations

from collections.abc import Mapping

REPOSITORIES = tuple(
    """
    ros-controls/ros2_control ros-controls/ros2_controllers ros-controls/gz_ros2_control
    ros-controls/kinematics_interface ros-controls/control_toolbox PickNikRobotics/topic_based_ros2_control
    ros-navigation/navigation2 SteveMacenski/slam_toolbox cra-ros-pkg/robot_localization
    ros-navigation/nav2_minimal_turtlebot_simulation cartographer-project/cartographer_ros introlab/rtabmap_ros
    moveit/moveit2 gazebosim/ros_gz ros-simulation/gazebo_ros_pkgs
    ros2/rviz ros/robot_state_publisher ros/joint_state_publisher ros2/geometry2 ros/xacro ros/urdf_launch
    ros2/rclcpp ros2/demos ros2/examples ros/ros_tutorials ros2/rosbag2 ros-tooling/topic_tools
    ros-perception/image_common ros-perception/image_pipeline ros-perception/image_transport_plugins
    ros-perception/laser_filters ros-perception/perception_pcl ros-perception/pointcloud_to_laserscan
    ros-perception/depthimage_to_laserscan ros-perception/vision_opencv
    ros2/teleop_twist_keyboard ros-teleop/teleop_twist_joy ros-teleop/teleop_tools ros-teleop/twist_mux
    ros-drivers/joystick_drivers ros-drivers/usb_cam ros-drivers/velodyne ros-drivers/urg_node
    ros-drivers/nmea_navsat_driver ros-drivers/phidgets_drivers
    CCNYRoboticsLab/imu_tools AprilRobotics/apriltag_ros IntelRealSense/realsense-ros mavlink/mavros
    RobotWebTools/rosbridge_suite foxglove/ros-foxglove-bridge ros/diagnostics ros/filters
    ros-visualization/rqt ros-visualization/rqt_robot_steering cyberbotics/webots_ros2
    stereolabs/zed-ros2-wrapper luxonis/depthai-ros KumarRobotics/ublox christianrauch/camera_ros
    """.split()
)

RENAMED: Mapping[str, str] = {
    "dwb_controller dwb_controller": "nav2_controller/controller_server",
    "joint_state_controller joint_state_controller/JointStateController": (
        "joint_state_broadcaster/JointStateBroadcaster"
    ),
    "nav2_map_server map_saver": "map_saver_cli",
    "nav2_navfn_planner navfn_planner": "nav2_planner/planner_server",
    "nav2_recoveries nav2_recoveries/BackUp": "nav2_behaviors/BackUp",
    "nav2_recoveries nav2_recoveries/Spin": "nav2_behaviors/Spin",
    "nav2_recoveries nav2_recoveries/Wait": "nav2_behaviors/Wait",
    "nav2_recoveries recoveries_node": "nav2_behaviors/behavior_server",
    "nav2_recoveries recoveries_server": "nav2_behaviors/behavior_server",
    "rtabmap_ros rtabmap_ros/Info": "rtabmap_rviz_plugins/Info",
    "rtabmap_ros rtabmap_ros/MapCloud": "rtabmap_rviz_plugins/MapCloud",
    "rtabmap_ros rtabmap_ros/MapGraph": "rtabmap_rviz_plugins/MapGraph",
    "rtabmap_ros rtabmapviz": "rtabmap_viz/rtabmap_viz",
    "smac_planner smac_planner/SmacPlanner": "nav2_smac_planner/SmacPlannerHybrid",
    "smac_planner smac_planner/SmacPlanner2D": "nav2_smac_planner/SmacPlanner2D",
    "velodyne_pointcloud velodyne_convert_node": "velodyne_transform_node",
}
"""What is called otherwise now: package and name, then the name, with its package where that is another one."""

VOUCHED: Mapping[str, frozenset[str]] = {
    "programs": frozenset({"rviz2", "xacro", "foxglove_bridge", "moveit_servo"}),
    "components": frozenset(),
    "plugins": frozenset(
        "hardware_interface force_torque_sensor_broadcaster moveit_kinematics nav2_costmap_2d nav2_smoother".split()
    ),
}
"""Packages whose names were compared by hand with what they install, though a part of their build is not evaluated."""

ON_PATH: Mapping[str, tuple[str, ...]] = {"rviz2": ("rviz2",), "xacro": ("xacro",)}
"""Programs that are in lib/<package> and in bin/."""
