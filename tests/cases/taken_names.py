"""Packages of ROS 1 beside what took their place."""

from __future__ import annotations

from .others import python

CASES = {
    "DEP203": (
        python("  <exec_depend>rclpy</exec_depend>\n  <exec_depend>rospy</exec_depend>\n"),
        python("  <exec_depend>rclcpp</exec_depend>\n  <exec_depend>rospy</exec_depend>\n"),
    ),
}
