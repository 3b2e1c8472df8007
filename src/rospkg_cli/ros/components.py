"""Components of libraries that CMake finds part by part (Boost, Qt, OpenCV), and what comes with each."""

from __future__ import annotations

from collections.abc import Iterable

from ..lazy_regex import regex
from .read_table import rows

TABLE = "components.txt"
ALWAYS = frozenset({"boost", "headers", "diagnostic_definitions", "disable_autolinking", "dynamic_linking"})
"""Targets of Boost that are there without any component."""
PLAIN = regex(
    r"ament_\w+|rosidl_\w+|rclcpp\w*|\w+_(?:msgs|srvs|interfaces|actions)|tf2|tf2_ros|tf2_eigen|builtin_interfaces"
    r"|rcutils|rcpputils|Eigen3|eigen3_cmake_module|yaml-cpp|Threads|OpenMP|fmt|spdlog|nlohmann_json|pluginlib|PkgConfig"
)
"""Packages that find neither Boost nor Qt nor OpenCV for their users."""


def family(library: str) -> str:
    """Return the section of a library's components; "" for one that is not known so."""
    return {"Boost": "Boost", "Qt5": "Qt", "Qt6": "Qt", "OpenCV": "OpenCV"}.get(library, "")


def is_component(library: str, name: str) -> bool:
    return bool(family(library)) and name in rows(TABLE, family(library))


def with_needed(library: str, names: Iterable[str]) -> frozenset[str] | None:
    """Return components and all that come with them; None where one is not known."""
    table, found, waiting = rows(TABLE, family(library)), set[str](), list(names)
    while waiting:
        name = waiting.pop()
        if name not in table:
            return None
        if name not in found:
            found.add(name)
            waiting += table[name]
    return frozenset(found)


def component_of_call(name: str) -> str:
    """Return the component of OpenCV that has a function or a class; "" where that is not known."""
    return next((part for part, calls in rows(TABLE, "calls").items() if name in calls), "")
