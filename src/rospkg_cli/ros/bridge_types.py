"""Which types of Gazebo ros_gz_bridge has for which messages of ROS."""

from __future__ import annotations

from collections.abc import Mapping

from .read_table import rows

BRIDGED: Mapping[str, tuple[str, ...]] = rows("bridge_types.txt")
"""`package/Type` of ROS → the types of Gazebo, without `gz.msgs.`, on any distribution."""
