"""What a C++ node is linked against, and how CMake finds it."""

from __future__ import annotations

import re

from ..ros.distros import Distro
from ..ros.manifest import PACKAGE_NAME
from ..ros.names import BUILT_IN
from .requested_node import RequestedNode

OF_CMAKE_17 = frozenset({"humble", "jazzy", "kilted"})
"""The distributions whose C++ is of 2017; later ones want that of 2020."""


def libraries_of(node: RequestedNode) -> dict[str, str]:
    """Return the packages of the client library that a node needs, and their targets."""
    generated = {"generate_parameter_library": node.definitions} if node.definitions else {}
    return {"rclcpp": "rclcpp::rclcpp", **generated, **node.kind.libraries}


def packages_of(nodes: tuple[RequestedNode, ...]) -> tuple[str, ...]:
    """Return the packages of the client library that all nodes need, each once, parameters included."""
    found = dict.fromkeys(package for node in nodes for package in libraries_of(node))
    if any(node.declares for node in nodes):
        found["rcl_interfaces"] = None
    return tuple(found)


def targets_of(node: RequestedNode) -> list[str]:
    """Return what a node is linked against, in order."""
    messages = [*node.kind.interfaces, *(["rcl_interfaces"] if node.declares else [])]
    return sorted([*libraries_of(node).values(), *(f"${{{package}_TARGETS}}" for package in messages)], key=by_name)


def by_name(target: str) -> str:
    return re.sub(r"^\$\{", "", target)


def cpp_standard(distro: Distro) -> str:
    """Return the feature by which CMake asks for a distribution's C++."""
    return "cxx_std_17" if distro.name in OF_CMAKE_17 else "cxx_std_20"


def is_library(key: str) -> bool:
    """Return whether a key is one to build against: Python's are for when the package runs."""
    return not key.startswith("python3-")


def cmake_names(keys: tuple[str, ...]) -> list[str]:
    """Return the keys that `find_package` finds under their own name: those of ROS packages."""
    return [
        key for key in keys if BUILT_IN.is_package(key) or (PACKAGE_NAME.fullmatch(key) and not BUILT_IN.is_key(key))
    ]
