"""By which spellings CMake finds a package: as `<Name>Config.cmake` by its own, as `<name>-config.cmake` by any case.

It looks for the second one with the name in small letters, in folders whose names fit in any case.
"""

from __future__ import annotations

from collections.abc import Iterable

from ..lazy_regex import regex
from .link_targets import MESSAGES

OF_AMENT = regex(r"(?:ament_|rosidl_|rmw|rcl|tf2)\w*")
"""Families of packages that ament_package() writes the config file of."""
OF_LIBRARIES = frozenset({"PCL", "OpenCV", "Eigen3"})
"""Libraries whose file is surely called like PCLConfig.cmake."""


def is_cased(name: str) -> bool:
    """Return whether a package is certainly not found by its name in other letters."""
    return name in OF_LIBRARIES or bool(OF_AMENT.fullmatch(name) or MESSAGES.fullmatch(name))


def in_other_case(name: str, names: Iterable[str]) -> list[str]:
    """Return those of some names that differ from one in case alone."""
    small = name.lower()
    return [each for each in names if each != name and each.lower() == small]
