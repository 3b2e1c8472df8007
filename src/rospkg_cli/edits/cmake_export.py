"""Edits that export a dependency in CMakeLists.txt."""

from __future__ import annotations

from ..finding import Edit
from ..languages.cmake.syntax import CommandInvocation
from ..package.cmake.cmake_project import CMake
from .cmake_commands import add_after, add_argument
from .cmake_install import add_rule


def export_dependency(cmake: CMake, name: str, *, first: bool) -> Edit | None:
    """Name a package in the last call of ament_export_dependencies, or in a new one below the other exports.

    Where there is no call yet, the first package makes it, and the others wait for that.
    """
    root = cmake.root
    commands = [each for each in root.body if isinstance(each, CommandInvocation)]
    exports = [each for each in commands if each.name == "ament_export_dependencies"]
    plain = [each for each in exports if each.arguments and not any("$" in a.text for a in each.arguments)]
    if plain:
        return add_argument(root, plain[-1], name)
    if not first:
        return None
    others = exports or [each for each in commands if each.name.startswith("ament_export_")]
    if others:
        return add_after(root, others[-1], f"ament_export_dependencies({name})")
    return add_rule(cmake, f"ament_export_dependencies({name})")
