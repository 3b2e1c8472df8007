"""Where find_package() goes: below the others."""

from __future__ import annotations

from ..finding import Edit
from ..model.cmake.call import Call
from ..model.cmake.project import CMake
from ..model.cmake.syntax import Command
from .cmake import add_after, add_before


def find(cmake: CMake, name: str, before: Call) -> tuple[Edit, ...]:
    """Look for a package before a call that needs it, below the last one that is looked for; nothing where one does."""
    if any(each.name == name for each in cmake.packages):
        return ()
    file = cmake.file(before.path)
    line = f"find_package({name} REQUIRED)"
    end = before.command.span.start
    commands = [each for each in file.body if isinstance(each, Command) and each.span.end <= end]
    found = [each for each in commands if each.name == "find_package"]
    if found:
        return (add_after(file, found[-1], line),)
    return (add_before(file, before.command, line),)
