"""What functions of rclpy, its nodes and ament_index_python take by position, in each distribution from Humble on."""

from __future__ import annotations

from ..light_dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class CallSignature:
    required: tuple[str, ...] = ()
    """What a call must give, by position or by name."""
    most: int = 0
    """How many arguments may be given by position; what else there is, is given by name."""


NONE = CallSignature()
OF_RCLPY = {
    "init": NONE,
    "ok": NONE,
    "shutdown": NONE,
    "try_shutdown": NONE,
    "create_node": CallSignature(("node_name",), 1),
    "spin": CallSignature(("node",), 2),
    "spin_once": CallSignature(("node",), 1),
    "spin_until_future_complete": CallSignature(("node", "future"), 4),
}
OF_NODES = {
    "create_client": CallSignature(("srv_type", "srv_name"), 2),
    "create_publisher": CallSignature(("msg_type", "topic", "qos_profile"), 3),
    "create_service": CallSignature(("srv_type", "srv_name", "callback"), 3),
    "create_subscription": CallSignature(("msg_type", "topic", "callback", "qos_profile"), 4),
    "create_timer": CallSignature(("timer_period_sec", "callback"), 5),
}
OF_INDEX = {
    "get_package_prefix": CallSignature(("package_name",), 1),
    "get_package_share_directory": CallSignature(("package_name",), 2),
    "get_package_share_path": CallSignature(("package_name",), 2),
}
INDEX = "ament_index_python"
"""The package of these, which offers them itself, too."""
REEXPORTED = {
    f"sensor_msgs_py/point_cloud2/{name}": f"sensor_msgs/msg/{name}" for name in ("PointCloud2", "PointField")
}
"""Messages that modules of common packages import, so that their users take them from there."""
