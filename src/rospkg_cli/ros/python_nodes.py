"""Well-known packages whose nodes are written in Python, and how the name of such a node is recognized."""

from __future__ import annotations

PYTHON_PACKAGES = frozenset({
    "demo_nodes_py", "diagnostic_common_diagnostics", "joint_state_publisher", "joint_state_publisher_gui",
    "joy_teleop", "key_teleop", "mouse_teleop", "nmea_navsat_driver", "nmea_hardware_interface_py", "rosapi",
    "rosbridge_server", "sound_play", "teleop_tools", "teleop_twist_keyboard", "twist_stamper",
})  # fmt: skip
"""Those that have no node in C++."""
ENDING = "_py"


def is_python_package(name: str) -> bool:
    """Return whether all nodes of a package are known, or likely by its name, to be Python."""
    return name in PYTHON_PACKAGES or name.endswith(ENDING)
