"""Qualities of service by name, as Python and C++ write them (rclpy.qos and rclcpp/qos.hpp since Humble)."""

from __future__ import annotations

from ..light_dataclasses import dataclass


@dataclass(frozen=True)
class QualityOfService:
    cpp: str
    python: str
    imports: tuple[str, ...] = ()
    """The names of rclpy.qos that `python` needs."""


DEFAULT = QualityOfService("10", "10")

QOS = {
    "sensor_data": QualityOfService("rclcpp::SensorDataQoS()", "qos_profile_sensor_data", ("qos_profile_sensor_data",)),
    "best_effort": QualityOfService(
        "rclcpp::QoS(10).best_effort()",
        "QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT)",
        ("QoSProfile", "ReliabilityPolicy"),
    ),
    "transient_local": QualityOfService(
        "rclcpp::QoS(1).transient_local()",
        "QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)",
        ("DurabilityPolicy", "QoSProfile"),
    ),
}
"""What may be typed behind a topic: for sensors, for what may be lost, and for what late listeners should get too."""
