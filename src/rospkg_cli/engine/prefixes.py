"""Names of the packages that are installed on this machine: they may silence a finding, never cause one."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path


def prefix_names(environment: Mapping[str, str]) -> frozenset[str]:
    """Return the names in the resource index of every prefix of AMENT_PREFIX_PATH, and of /opt/ros/<distro>."""
    prefixes = [p for p in environment.get("AMENT_PREFIX_PATH", "").split(":") if p]
    if environment.get("ROS_DISTRO"):
        prefixes.append(f"/opt/ros/{environment['ROS_DISTRO']}")
    names: set[str] = set()
    for prefix in prefixes:
        index = Path(prefix, "share/ament_index/resource_index/packages")
        if index.is_dir():
            names |= {entry.name for entry in index.iterdir()}
    return frozenset(names)
