"""Names from elsewhere for what rosdep and ROS 2 call otherwise: PyPI, Ubuntu, CMake, ROS 1."""

from __future__ import annotations

import re

from ..lazy_regex import regex
from .distros import DISTROS
from .imports import keys_called_like
from .names import BUILT_IN, Names
from .read_table import marked, pairs, rows

OF_ROS = regex(rf"ros-(?:{'|'.join(each.name for each in DISTROS)})-([a-z0-9-]+)")
"""What Ubuntu's packages of ROS packages are called."""

NOTHING_NEEDED = "-"


def key_for_pip(name: str, names: Names = BUILT_IN) -> str | None:
    """Return the rosdep key for a name on PyPI; None where none is known."""
    normal = re.sub(r"[-_.]+", "-", name).lower()
    if found := pairs("pypi_apt.txt").get(normal):
        return found
    likely = [key for key in keys_called_like(normal) if names.is_key(key)]
    listed = {re.sub(r"[-_.]+", "-", pip).lower(): keys for pip, keys in names.pip.items()}
    return next(iter([*likely, *listed.get(normal, ())]), None)


def key_for_apt(name: str, names: Names = BUILT_IN) -> str | None:
    """Return the rosdep key, or the ROS package, for a package of Ubuntu that is called otherwise; else None."""
    released = OF_ROS.fullmatch(name)
    if released:
        package = released[1].replace("-", "_")
        return package if names.is_package(package) else None
    keys = names.apt.get(name, ())
    return keys[0] if len(keys) == 1 and "-" in name and not names.is_key(name) else None


def keys_for_cmake(name: str) -> tuple[str, ...]:
    """Return what serves find_package(name), the preferred one first; a pattern (`libopencv-*`) may be among them.

    Empty for an unknown name; `-` among them means that nothing has to be declared.
    """
    return rows("cmake.txt").get(name, ())


def last_ros1_distro(name: str) -> str:
    """Return the last distribution of ROS 1 that had a package which no distribution of ROS 2 ever had; else ""."""
    return next(iter(marked("ros1_packages.txt").get(name, ())), "")


def successors(name: str) -> tuple[str, ...] | None:
    """Return what took the place of a ROS 1 package; None for a name that is not ROS 1's alone."""
    found = rows("ros1.txt").get(name)
    return None if found is None else tuple(each for each in found if each != NOTHING_NEEDED)
