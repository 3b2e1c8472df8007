"""What the module rclpy and its nodes have, and what takes the place of names of rospy."""

from __future__ import annotations

from .read_table import sets

TABLE = "rclpy_names.txt"

OF_ROSPY = {
    "Duration": "rclpy.duration.Duration",
    "Publisher": "node.create_publisher()",
    "ROSException": "rclpy.exceptions.ROSInterruptException",
    "ROSInterruptException": "rclpy.exceptions.ROSInterruptException",
    "Rate": "node.create_rate()",
    "Service": "node.create_service()",
    "ServiceProxy": "node.create_client()",
    "Subscriber": "node.create_subscription()",
    "Time": "rclpy.time.Time",
    "Timer": "node.create_timer()",
    "get_name": "node.get_name()",
    "get_param": "node.get_parameter()",
    "get_rostime": "node.get_clock().now()",
    "get_time": "node.get_clock().now()",
    "has_param": "node.has_parameter()",
    "init_node": "rclpy.create_node()",
    "is_shutdown": "not rclpy.ok()",
    "logdebug": "node.get_logger().debug()",
    "logerr": "node.get_logger().error()",
    "logfatal": "node.get_logger().fatal()",
    "loginfo": "node.get_logger().info()",
    "logwarn": "node.get_logger().warning()",
    "on_shutdown": "rclpy.get_default_context().on_shutdown()",
    "set_param": "node.set_parameters()",
    "signal_shutdown": "rclpy.shutdown()",
    "sleep": "time.sleep()",
    "wait_for_service": "client.wait_for_service()",
}
"""Names of rospy that rclpy never had, with what is written in their place."""


def names_of_rclpy() -> frozenset[str]:
    """Return the names of the module; submodules are among them, as anything may import these."""
    known = sets(TABLE)
    return known["rclpy"] | known["submodules"]


def members_of_nodes() -> frozenset[str]:
    known = sets(TABLE)
    return known["Node"] | known["LifecycleNodeMixin"]
