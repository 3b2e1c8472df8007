"""Names of the packages that are installed on this machine: they may prevent a finding, never cause one."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from pathlib import Path

from ...disk_trace import is_folder, names_in

INSTALLED = Path("/opt/ros")
"""Where Debian packages of ROS put each distribution."""


def installed_package_names(environment: Mapping[str, str], installed: Path = INSTALLED) -> frozenset[str]:
    """Return the names in the resource index of every prefix of AMENT_PREFIX_PATH, and of /opt/ros/<distro>.

    Where ROS_DISTRO does not say which that is, of every distribution that is there.
    """
    names: set[str] = set()
    for prefix in prefixes(environment, installed):
        index = prefix / "share/ament_index/resource_index/packages"
        try:
            names.update(names_in(index))
        except OSError:
            continue
    return frozenset(names)


def prefixes(environment: Mapping[str, str], installed: Path) -> Iterator[Path]:
    yield from (Path(each) for each in environment.get("AMENT_PREFIX_PATH", "").split(os.pathsep) if each)
    if environment.get("ROS_DISTRO"):
        yield installed / environment["ROS_DISTRO"]
    elif is_folder(installed):
        yield from (installed / name for name in names_in(installed))
