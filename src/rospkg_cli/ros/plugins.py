"""Who loads which plug-ins: base class → the package under whose name their descriptions must be exported.

Taken from the arguments of pluginlib::ClassLoader (and rviz_common's PluginlibFactory) in the sources of navigation2,
moveit2, ros2_control, rviz and image_transport.
"""

from __future__ import annotations

from collections.abc import Mapping

RQT = frozenset({"rqt_gui", "qt_gui"})
"""These read `<export><rqt_gui plugin="…"/></export>` of package.xml; all others go by what CMake exports."""

LOADED_FROM: Mapping[str, str] = {
    "controller_interface::ChainableControllerInterface": "controller_interface",
    "controller_interface::ControllerInterface": "controller_interface",
    "hardware_interface::ActuatorInterface": "hardware_interface",
    "hardware_interface::SensorInterface": "hardware_interface",
    "hardware_interface::SystemInterface": "hardware_interface",
    "image_transport::PublisherPlugin": "image_transport",
    "image_transport::SubscriberPlugin": "image_transport",
    "kinematics::KinematicsBase": "moveit_core",
    "moveit_controller_manager::MoveItControllerManager": "moveit_core",
    "planning_interface::PlannerManager": "moveit_core",
    "planning_interface::PlanningRequestAdapter": "moveit_core",
    "planning_interface::PlanningResponseAdapter": "moveit_core",
    "nav2_core::Behavior": "nav2_core",
    "nav2_core::Controller": "nav2_core",
    "nav2_core::GlobalPlanner": "nav2_core",
    "nav2_core::GoalChecker": "nav2_core",
    "nav2_core::NavigatorBase": "nav2_core",
    "nav2_core::ProgressChecker": "nav2_core",
    "nav2_core::Smoother": "nav2_core",
    "nav2_core::WaypointTaskExecutor": "nav2_core",
    "nav2_costmap_2d::Layer": "nav2_costmap_2d",
    "rviz_common::Display": "rviz_common",
    "rviz_common::Panel": "rviz_common",
    "rviz_common::Tool": "rviz_common",
    "rviz_common::ViewController": "rviz_common",
    "rviz_common::transformation::FrameTransformer": "rviz_common",
    "rviz_default_plugins::PointCloudTransformer": "rviz_default_plugins",
}

PLUGIN_HOMES: Mapping[str, str] = {
    "chomp_interface": "moveit_planners_chomp",
    "default_planner_request_adapters": "moveit_ros_planning",
    "default_planning_request_adapters": "moveit_ros_planning",
    "default_planning_response_adapters": "moveit_ros_planning",
    "fake_components": "hardware_interface",
    "kdl_kinematics_plugin": "moveit_kinematics",
    "lma_kinematics_plugin": "moveit_kinematics",
    "cached_ik_kinematics_plugin": "moveit_kinematics",
    "mock_components": "hardware_interface",
    "moveit_rviz_plugin": "moveit_ros_visualization",
    "ompl_interface": "moveit_planners_ompl",
    "stomp_moveit": "moveit_planners_stomp",
}
"""The packages of plug-ins that are called after something else, by what stands before the class."""

TOOLS = frozenset({"rviz_common", "rviz_default_plugins"})
"""What comes with the only program that reads their names."""
