"""One CMake file of a package: parsed, or an error where CMake would refuse it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...read_problem import ReadProblem
from ...source import Source, Span
from ...unreadable import UnreadableError
from ..syntax_problem import SyntaxProblem
from .command_blocks import Block, nest
from .parser import parse
from .syntax import CMakeSyntax, CommandInvocation

ROOT = "CMakeLists.txt"
MAX_LENGTH = 500_000
"""In characters; what people write has a hundredth of that."""
ENDS = ("ament_package", "ament_auto_package", "autoware_ament_auto_package")
INDENT = regex(r"^([ \t]+)(?=\S)", re.MULTILINE)
SETTERS = {"set": 0, "option": 0, "list": 1, "foreach": 0, "get_filename_component": 0, "set_property": 0}
"""The index of the argument that names the variable which a command sets."""


@dataclass(frozen=True)
class CMakeFile:
    """One file that can be read: its commands, flat and in their blocks."""

    syntax: CMakeSyntax
    body: list[CommandInvocation | Block]

    @property
    def source(self) -> Source:
        return self.syntax.source

    @property
    def path(self) -> str:
        return self.syntax.source.path

    @cached_property
    def top(self) -> tuple[CommandInvocation, ...]:
        """The commands outside of blocks, in order."""
        return tuple(each for each in self.body if isinstance(each, CommandInvocation))

    @cached_property
    def _top(self) -> frozenset[int]:
        return frozenset(map(id, self.top))

    def is_top(self, command: CommandInvocation) -> bool:
        """Return whether a command is one of this file's, outside of blocks."""
        return id(command) in self._top

    @cached_property
    def last_install(self) -> CommandInvocation | None:
        """The last `install` outside of blocks."""
        return next((each for each in reversed(self.top) if each.name == "install"), None)

    @cached_property
    def end(self) -> CommandInvocation | None:
        """The command that opens the block of the tests, or ends the package, whichever comes first."""
        for each in self.body:
            first = each.command if isinstance(each, Block) else each
            tests = isinstance(each, Block) and any("BUILD_TESTING" in a.text for a in first.arguments)
            if tests or first.name in ENDS:
                return first
        return None

    @cached_property
    def indent(self) -> str:
        """What arguments and bodies are indented by; two blanks where none is."""
        return min(INDENT.findall(self.source.text), key=len, default="  ")

    @cached_property
    def is_upper(self) -> bool:
        """Whether most commands are written in upper case."""
        names = [self.source.slice(command.name_span) for command in self.syntax.commands]
        return sum(map(str.isupper, names)) * 2 > len(names)


def read_file(files: PackageFiles, path: str) -> CMakeFile:
    """Read one file; raises UnreadableError at the first place that CMake would refuse, and for one too large."""
    source = files.source(path)
    if len(source.text) > MAX_LENGTH:
        raise UnreadableError(path, Span(0, 0), ReadProblem.CMAKE_LENGTH, f"{MAX_LENGTH:,}", skipped=True)
    syntax = parse(source)
    body, problems = nest(syntax.commands)
    raise_first(path, syntax.problems or tuple(problems))
    return CMakeFile(syntax, body)


def raise_first(path: str, problems: tuple[SyntaxProblem, ...]) -> None:
    if problems:
        first = problems[0]
        raise UnreadableError(path, first.span, first.code, *first.details)


def assigned_names(file: CMakeFile) -> Iterator[str]:
    """Yield the names of variables that a file sets somewhere by a literal name."""
    for command in file.syntax.commands:
        at = SETTERS.get(command.name)
        if at is not None and len(command.arguments) > at:
            yield command.arguments[at].text
