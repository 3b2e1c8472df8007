"""Where a new install rule of CMake goes, or an item that fits a rule that is there."""

from __future__ import annotations

from collections.abc import Callable

from ..finding import Edit
from ..languages.cmake.evaluated_command import EvaluatedCommand
from ..languages.cmake.file import CMakeFile
from ..languages.cmake.syntax import CommandInvocation
from ..package.cmake.cmake_project import CMake
from ..package.cmake.install_rule import InstallRule
from .cmake_commands import add_after, add_argument, add_at_end, add_block_before, quoted_like


def extend_or_add(
    cmake: CMake, fits: Callable[[InstallRule], bool], item: str, lines: str, made: EvaluatedCommand | None = None
) -> Edit:
    """Put an item into the last rule that fits, in CMakeLists.txt or where the item is made, else add a rule.

    `made` is the call that makes the item, where it is a target: CMake wants it first.
    """
    if made is not None and made.maybe:
        inside = "\n".join(f"{cmake.root.indent}{line}" for line in lines.split("\n"))
        return add_rule(cmake, f"if(TARGET {item})\n{inside}\nendif()", made)
    for rule in reversed(cmake.installs):
        command = rule.call.command
        near = rule.call.path in (cmake.root.path, made.path if made else "")
        file = cmake.file(rule.call.path)
        if near and file.is_top(command) and runs_after(cmake, command, made) and not rule.call.maybe and fits(rule):
            last = rule.items[-1:]
            written = [argument for argument, words in rule.call.by_argument() if last and words[-1:] == last]
            if written:
                return add_argument(file, command, quoted_like(file, item, written[0].span), written[0].span)
    return add_rule(cmake, lines, made)


def runs_after(cmake: CMake, command: CommandInvocation, made: EvaluatedCommand | None) -> bool:
    """Return whether a command runs after a call."""
    if made is None:
        return True
    return cmake.last_index(command) > cmake.last_index(made.command)


def add_rule(cmake: CMake, lines: str, made: EvaluatedCommand | None = None) -> Edit:
    """Put a rule below the last one, else before the tests and ament_package()."""
    root = cmake.root
    last = root.last_install
    if last is not None and runs_after(cmake, last, made):
        return add_after(root, last, f"\n{lines}")
    end = root.end
    if end is None and (nested := in_block_of_package(root, lines)) is not None:
        return nested
    return add_at_end(root, lines) if end is None else add_block_before(root, end, lines)


def in_block_of_package(root: CMakeFile, lines: str) -> Edit | None:
    """Put a rule into the block that holds ament_package(): below its last rule, else before that command."""
    ends = [each for each in root.syntax.commands if each.name == "ament_package"]
    if len(ends) != 1:
        return None
    indent = indent_of(root, ends[0])
    shifted = "\n".join(f"{indent}{line}" if line else line for line in lines.split("\n"))
    inside: list[CommandInvocation] = []
    for each in root.syntax.commands[: root.syntax.commands.index(ends[0])]:
        if len(indent_of(root, each)) < len(indent):
            inside.clear()
        elif each.name == "install" and indent_of(root, each) == indent:
            inside.append(each)
    return add_after(root, inside[-1], f"\n{shifted}") if inside else add_block_before(root, ends[0], shifted)


def indent_of(root: CMakeFile, command: CommandInvocation) -> str:
    """Return the blanks before a command, or all that is before it in its line."""
    line = root.source.line_span(root.source.position(command.span.start)[0])
    return root.source.text[line.start : command.span.start]


def block(file: CMakeFile, kind: str, item: str, destination: str) -> str:
    indent = file.indent
    return f"install({kind} {item}\n{indent}DESTINATION {destination}\n)"
