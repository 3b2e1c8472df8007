"""Parameters without which nodes that everybody uses do not start, in all supported distributions before Lyrical."""

from __future__ import annotations

from ..light_dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Needed:
    name: str
    harm: str
    instead: str = ""
    """Another parameter that makes up for it."""
    takes_file: bool = False
    """Whether an argument that is a file makes up for it."""


ROBOT = Needed(
    "robot_description", 'stops: "robot_description parameter must not be empty"', "use_robot_description_topic", True
)
MAP = Needed("yaml_filename", "can't be configured, as it declares no default")
NAMES = Needed("node_names", "stops, as it declares no default")
NEEDED = {
    ("robot_state_publisher", "robot_state_publisher"): ROBOT,
    ("robot_state_publisher", "robot_state_publisher::RobotStatePublisher"): ROBOT,
    ("nav2_map_server", "map_server"): MAP,
    ("nav2_map_server", "nav2_map_server::MapServer"): MAP,
    ("nav2_lifecycle_manager", "lifecycle_manager"): NAMES,
    ("nav2_lifecycle_manager", "nav2_lifecycle_manager::LifecycleManager"): NAMES,
}
"""By package and program, or the class of a component."""
