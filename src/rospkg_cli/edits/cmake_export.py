"""Edits that export a dependency in CMakeLists.txt."""

from __future__ import annotations

from collections.abc import Sequence

from ..finding import Edit
from ..languages.cmake.syntax import CommandInvocation
from ..package.cmake.cmake_project import CMake
from .cmake_commands import add_after, add_argument, listed
from .cmake_install import add_rule

WIDTH = 99
"""The longest line for packages; ament_lint_cmake allows more."""


def export_dependencies(cmake: CMake, names: Sequence[str]) -> Edit:
    """Name packages in the last call of ament_export_dependencies, or in a new one below the other exports."""
    root = cmake.root
    commands = [each for each in root.body if isinstance(each, CommandInvocation)]
    exports = [each for each in commands if each.name == "ament_export_dependencies"]
    plain = [each for each in exports if each.arguments and not any("$" in a.text for a in each.arguments)]
    if plain:
        edits = [add_argument(root, plain[-1], name) for name in names]
        return Edit(edits[0].path, edits[0].span, "".join(edit.text for edit in edits))
    call = f"ament_export_dependencies({' '.join(names)})"
    if len(call) > WIDTH:
        call = f"ament_export_dependencies({listed(names, root.indent)}\n)"
    others = exports or [each for each in commands if each.name.startswith("ament_export_")]
    return add_after(root, others[-1], call) if others else add_rule(cmake, call)
