"""Edits of install rules with a wrong destination for executables."""

from __future__ import annotations

from ..checks.cmake.misplaced_executables import MisplacedExecutable
from ..finding import Edit
from ..languages.cmake.syntax import CommandArgument
from ..package.cmake.cmake_project import CMake
from ..package.cmake.empty_destinations import empty_destination
from ..source import Span
from .cmake_commands import add_after
from .cmake_install import LIBEXEC
from .cmake_rule_place import block


def to_libexec(cmake: CMake, astray: MisplacedExecutable) -> tuple[Edit, ...]:
    """Send an executable to lib/<package>: with its whole rule where that is about executables, else in a new one."""
    rule = astray.rule
    if rule.kind not in ("TARGETS", "PROGRAMS"):
        return ()  # it would have to be another one
    file = cmake.file(rule.call.path)
    arguments = [argument for argument, words in rule.call.by_argument() if words and astray.word in words]
    place = rule.destination_word
    alone = all(is_executable(cmake, word.text) for word in rule.items) if rule.kind == "TARGETS" else True
    if alone and (keyword := empty_destination(rule)) is not None:
        return (Edit(file.path, Span(keyword.span.end, keyword.span.end), f" {LIBEXEC}"),)
    if (
        alone
        and place is not None
        and place.path == file.path
        and len(set((rule.destinations or {"": ""}).values())) == 1
    ):
        return tuple(
            Edit(file.path, argument.span, LIBEXEC)
            for argument, words in rule.call.by_argument()
            if len(words) == 1 and is_destination(cmake, rule.call.command.arguments, argument)
        )
    if len(arguments) != 1 or len(rule.items) < 2:
        return ()
    span = arguments[0].span
    text = file.source.text
    start = span.start
    while text[start - 1] in " \t\n":
        start -= 1
    lines = block(file, rule.kind, file.source.slice(span), LIBEXEC)
    return (Edit(file.path, Span(start, span.end), ""), add_after(file, rule.call.command, f"\n{lines}"))


def is_executable(cmake: CMake, name: str) -> bool:
    target = cmake.target(name)
    return target is not None and target.is_executable


def is_destination(cmake: CMake, arguments: tuple[CommandArgument, ...], argument: CommandArgument) -> bool:
    at = arguments.index(argument)
    return at > 0 and arguments[at - 1].text == "DESTINATION"
