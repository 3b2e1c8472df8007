"""Edits that add find_package(), below the others."""

from __future__ import annotations

from ..finding import Edit
from ..languages.cmake.evaluated_command import EvaluatedCommand
from ..languages.cmake.syntax import CommandInvocation
from ..package.cmake.cmake_project import CMake
from .cmake_commands import add_after, add_before, margin
from .plain_names import PLAIN


def add_find_package(cmake: CMake, name: str, before: EvaluatedCommand) -> tuple[Edit, ...]:
    """Look for a package before a call that needs it, below the last one that is looked for; nothing where one does."""
    if not PLAIN.fullmatch(name) or any(each.name == name for each in cmake.packages):
        return ()
    file = cmake.file(before.path)
    line = f"find_package({name} REQUIRED)"
    end = before.command.span.start
    commands = [each for each in file.body if isinstance(each, CommandInvocation) and each.span.end <= end]
    found = [each for each in commands if each.name == "find_package"]
    if found:
        return (add_after(file, found[-1], margin(file, found[-1]) + line),)
    return (add_before(file, before.command, margin(file, before.command) + line),)


def add_find_package_among(cmake: CMake, name: str, *, testing: bool) -> tuple[Edit, ...]:
    """Look for a package below the last one that is looked for, for tests or always; nothing where there is none."""
    calls = [each.call for each in cmake.packages if each.call.testing is testing and not each.call.maybe]
    alone = [call for call in calls if not call.function and is_alone(cmake, call)]
    if not alone or not PLAIN.fullmatch(name):
        return ()
    last = next((call for call in reversed(alone) if call.path == cmake.root.path), alone[-1])
    file = cmake.file(last.path)
    return (add_after(file, last.command, f"{margin(file, last.command)}find_package({name} REQUIRED)"),)


def is_alone(cmake: CMake, call: EvaluatedCommand) -> bool:
    """Return whether a command looks for one package: in a loop it looks for several."""
    return sum(each.call.command is call.command for each in cmake.packages) == 1
