"""Edits that export a dependency in CMakeLists.txt."""

from __future__ import annotations

from collections.abc import Sequence

from ..finding import Edit
from ..languages.cmake.file import CMakeFile
from ..languages.cmake.syntax import CommandInvocation
from ..package.cmake.cmake_project import CMake
from .cmake_commands import add_after, add_argument, listed
from .cmake_rule_place import add_rule

WIDTH = 99
"""The longest line for packages; ament_lint_cmake allows more."""


def export_dependencies(cmake: CMake, names: Sequence[str]) -> Edit:
    """Name packages in the last call of ament_export_dependencies, or in a new one below the other exports."""
    root = cmake.root
    commands = [each for each in root.body if isinstance(each, CommandInvocation)]
    exports = [each for each in commands if each.name == "ament_export_dependencies"]
    plain = [each for each in exports if each.arguments and not any("$" in a.text for a in each.arguments)]
    if plain:
        return append_names(root, plain[-1], names)
    call = f"ament_export_dependencies({' '.join(names)})"
    if len(call) > WIDTH:
        call = f"ament_export_dependencies({listed(names, root.indent)}\n)"
    others = exports or [each for each in commands if each.name.startswith("ament_export_")]
    return add_after(root, others[-1], call) if others else add_rule(cmake, call)


def append_names(file: CMakeFile, command: CommandInvocation, names: Sequence[str]) -> Edit:
    """Put names behind the last argument; each on its own line where a command of one line becomes too long."""
    source, last = file.source, command.arguments[-1].span
    edits = [add_argument(file, command, name) for name in names]
    behind = Edit(file.path, edits[0].span, "".join(edit.text for edit in edits))
    line = source.line_span(source.position(last.end)[0])
    has_comment = "#" in source.slice(command.inner)
    if "\n" in behind.text or line.end - line.start + len(behind.text) <= WIDTH or has_comment:
        return behind
    before = source.slice(line)
    indent = before[: len(before) - len(before.lstrip())]
    if line.start > command.span.start:
        return Edit(file.path, behind.span, f"\n{indent}{' '.join(names)}")
    every = [*(source.slice(each.span) for each in command.arguments), *names]
    return Edit(file.path, command.inner, f"{listed(every, indent + file.indent)}\n{indent}")
