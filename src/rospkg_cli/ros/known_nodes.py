"""The nodes of well-known packages by name, and the parameters that these and their plugins declare."""

from __future__ import annotations

from functools import cache

from ..light_dataclasses import dataclass
from .read_table import rows

NAMES = "node_names.txt"
TABLE = "well_known_parameters.txt"
NEWER = "newer_parameters.txt"
TYPES = {"b": "bool", "d": "double", "i": "int", "s": "string"}
TAIL = "*"


@dataclass(frozen=True, slots=True)
class KnownParameter:
    name: str
    """Where `is_tail`, what follows a part that is known at run time only, with the sign between them."""
    is_tail: bool
    type: str
    """bool, int, double or string, with `[]` for a list of them; "" where it is unknown, or releases differ."""

    def fits(self, name: str) -> bool:
        """Return whether a parameter of this name is this one."""
        if not self.is_tail:
            return name == self.name
        return name.endswith(self.name if self.name[0] in "._" else f".{self.name}")


def known_nodes() -> dict[str, tuple[str, ...]]:
    """Return the names of the nodes that everybody gives parameters to, with their packages."""
    return rows(NAMES)


@cache
def known_parameters(package: str) -> tuple[KnownParameter, ...]:
    """Return what a well-known package declares; nothing for any other."""
    return tuple(map(known_parameter, rows(TABLE).get(package, ())))


@cache
def newer_parameters(package: str) -> tuple[KnownParameter, ...]:
    """Return what a well-known package declares from Iron, Jazzy or later on; Humble has it nowhere."""
    return tuple(map(known_parameter, rows(NEWER).get(package, ())))


@cache
def removed_parameters(package: str) -> tuple[KnownParameter, ...]:
    """Return what a well-known package declared before the oldest supported distribution, and no more."""
    return tuple(map(known_parameter, rows(TABLE, "removed").get(package, ())))


def known_parameter(word: str) -> KnownParameter:
    name, _, kind = word.partition(":")
    brackets = kind[1:]
    return KnownParameter(name.removeprefix(TAIL), name.startswith(TAIL), TYPES[kind[0]] + brackets if kind else "")


DEFAULTS: dict[str, dict[str, str]] = {
    "nav2_costmap_2d": {
        "combination_method": "1", "cost_scaling_factor": "1.0", "enabled": "true", "inflate_around_unknown": "false",
        "inflate_unknown": "false", "inflation_radius": "0.55", "map_subscribe_transient_local": "true",
        "mark_threshold": "0", "max_obstacle_height": "2.0", "origin_z": "0.0", "publish_voxel_map": "false",
        "subscribe_to_updates": "false", "unknown_threshold": "15", "z_resolution": "0.2", "z_voxels": "10",
    },
}  # fmt: skip
"""What the parameters of plugins are where nothing is given, by package and the last part of their name."""
OF_NODES: dict[str, dict[str, str]] = {
    "diff_drive_controller": {"enable_odom_tf": "true", "open_loop": "false", "publish_limited_velocity": "false"},
    "joy": {
        "autorepeat_rate": "20.0", "coalesce_interval_ms": "1", "deadzone": "0.05", "device_id": "0",
        "sticky_buttons": "false",
    },
    "nav2_amcl": {
        "always_reset_initial_pose": "false", "first_map_only": "false", "set_initial_pose": "false",
        "tf_broadcast": "true",
    },
    "nav2_controller": {
        "controller_frequency": "20.0", "costmap_update_timeout": "0.3", "failure_tolerance": "0.0",
        "min_theta_velocity_threshold": "0.0001", "min_x_velocity_threshold": "0.0001",
        "min_y_velocity_threshold": "0.0001", "publish_zero_velocity": "true", "speed_limit_topic": "speed_limit",
        "use_realtime_priority": "false",
    },
    "nav2_planner": {"costmap_update_timeout": "1.0", "expected_planner_frequency": "1.0"},
    "robot_localization": {"print_diagnostics": "false", "publish_tf": "true", "two_d_mode": "false"},
    "turtlesim": {"background_b": "255", "background_g": "86", "background_r": "69"},
}  # fmt: skip
"""What the parameters of nodes are where nothing is given, alike in all distributions that have them."""


def default_of(package: str, name: str) -> str:
    """Return the default of a parameter of a well-known package, of a node or a plugin; "" where none is known."""
    if "." not in name:
        return OF_NODES.get(package, {}).get(name, "")
    return DEFAULTS.get(package, {}).get(name.rpartition(".")[2], "")


def is_same_value(text: str, default: str) -> bool:
    """Return whether a value is written as a default, or is the same number."""
    if not default or text.strip("\"'").lower() == default.lower():
        return bool(default)
    try:
        return float(text) == float(default)
    except ValueError:
        return False
