"""Packages that others are linked with for themselves alone, though their package.xml passes them on."""

from __future__ import annotations

from collections.abc import Mapping

FROM_JAZZY: Mapping[str, frozenset[str]] = {
    "camera_info_manager": frozenset({"ament_index_cpp"}),
    "rclcpp": frozenset({"ament_index_cpp", "rcl_logging_interface"}),
    "rclcpp_components": frozenset({"ament_index_cpp"}),
    "rmw_implementation": frozenset({"ament_index_cpp"}),
    "rosbag2_cpp": frozenset({"ament_index_cpp"}),
    "rviz_rendering": frozenset({"ament_index_cpp"}),
}
"""Package to what its targets hand on up to Humble, and no more from Jazzy on."""

KEPT_FROM_JAZZY = frozenset[str]().union(*FROM_JAZZY.values())
