"""Programs whose process has more nodes than the one that they are started as: all of them read its parameter files."""

from __future__ import annotations

from ...lazy_regex import regex
from ...package.launch.launched_parts import LaunchedNode

COSTMAPS = {"local_costmap": "controller_server", "global_costmap": "planner_server"}
"""The node, and the one that makes it. (nav2_controller, nav2_planner)"""
LOADS = regex(r"component_container\w*|ros2_control_node|move_group|gzserver|gazebo")
"""Programs that load nodes at run time: components, controllers, hardware, plugins."""

SINGLE = frozenset({
    "imu_filter_madgwick", "joint_state_publisher", "joy", "nav2_amcl", "nav2_map_server", "nav2_velocity_smoother",
    "robot_localization", "robot_state_publisher", "slam_toolbox", "teleop_twist_joy", "turtlesim", "twist_mux",
    "usb_cam", "v4l2_camera",
})  # fmt: skip
"""Well-known packages whose programs are one node each."""


def may_make(node: LaunchedNode, name: str) -> bool:
    """Return whether the process of a node may have another one of a name.

    A costmap of nav2 is a node inside of the server that uses it, which may be one's own.
    """
    program = (node.executable.literal or "") if node.executable is not None else ""
    return node.kind == "node_container" or LOADS.fullmatch(program) is not None or name in COSTMAPS
