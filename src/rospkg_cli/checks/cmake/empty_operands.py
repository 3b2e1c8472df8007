"""Operands of conditions that are empty for some, and stand without quotes: CMake stops (CMK123)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.command_blocks import Block
from ...languages.cmake.comparisons import BINARY
from ...languages.cmake.file import CMakeFile
from ...languages.cmake.syntax import CommandArgument, CommandInvocation
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage

OPERAND = regex(r"\$(ENV)?\{(\w+)\}")
ENVIRONMENT = "ros_environment"
OF_ROS = frozenset({"ROS_DISTRO", "ROS_VERSION", "ROS_PYTHON_VERSION"})
"""Variables of every shell that is set up for ROS, and of the build farm where `ros_environment` is declared."""
SET_UP = OF_ROS | {"AMENT_PREFIX_PATH", "LD_LIBRARY_PATH", "PYTHONPATH", "PATH", "HOME", "PWD"}
"""These, and others that no shell lacks in which a package for ROS is built."""
OFTEN_EMPTY = frozenset({"CMAKE_BUILD_TYPE", "ROS_DISTRO", "ROS_VERSION"})
"""Variables of CMake that only its user sets, if anyone does."""
ELSEWHERE = regex(r"WIN32|MSVC|APPLE|ANDROID|catkin|CATKIN|ROS1")


@dataclass(frozen=True, slots=True)
class EmptyOperand:
    path: str
    argument: CommandArgument
    is_mostly_set: bool
    """Whether it is set wherever ROS is used."""
    is_inner: bool
    """Whether the condition stands in a block, which CMake may never come to."""


@dataclass(frozen=True)
class EmptyOperands:
    package: CMakePackage

    def all(self) -> Iterator[EmptyOperand]:
        """Yield the first place of each operand that no file asks for or sets."""
        seen: set[str] = set()
        for file in self.package.cmake.files if self.package.is_ament else ():
            for condition, is_inner in conditions(file):
                for argument, following in compared(condition):
                    found = OPERAND.fullmatch(argument.text) if argument.kind == "unquoted" else None
                    if found and following.text in BINARY and argument.text not in seen:
                        seen.add(argument.text)
                        if self.may_be_empty(found[2], bool(found[1])):
                            is_mostly_set = bool(found[1]) and found[2] in SET_UP
                            yield EmptyOperand(file.path, argument, is_mostly_set, is_inner)

    def may_be_empty(self, name: str, is_of_environment: bool) -> bool:
        if is_of_environment:
            is_declared = any(need.name == ENVIRONMENT for need in self.package.facts.dependencies)
            return f"ENV{{{name}}}" not in self.words and not (name in OF_ROS and is_declared)
        is_read = not self.package.cmake.reads_unknown_files
        return is_read and name in OFTEN_EMPTY and name not in self.words

    @cached_property
    def words(self) -> frozenset[str]:
        """All arguments as they are written: what sets a variable, or asks for it, names it."""
        commands = (command for file in self.package.cmake.files for command in file.syntax.commands)
        return frozenset(argument.text for command in commands for argument in command.arguments)


def compared(condition: CommandInvocation) -> Iterator[tuple[CommandArgument, CommandArgument]]:
    """Yield the arguments of a condition that may be operands, each with the next one.

    Where nothing stands before a first MATCHES, CMake takes it for false, and goes on. (cmConditionEvaluator)
    """
    pairs = list(zip(condition.arguments, condition.arguments[1:], strict=False))
    has_matches = bool(pairs) and pairs[0][1].text == "MATCHES"
    yield from pairs[1:] if has_matches else pairs


def conditions(file: CMakeFile) -> Iterator[tuple[CommandInvocation, bool]]:
    """Yield the conditions of a file that are evaluated on Linux with ROS 2, as far as those around them tell, and
    whether each stands in another block; those that certainly don't come first."""
    waiting = [(each, False) for each in reversed(file.body) if isinstance(each, Block)]
    inner: list[tuple[Block, bool]] = []
    while waiting or inner:
        block, is_inner = waiting.pop() if waiting else inner.pop()
        for branch in block.branches:
            if branch.command.name in ("if", "elseif", "while"):
                yield branch.command, is_inner
        is_elsewhere = any(ELSEWHERE.search(each.text) for each in block.command.arguments)
        blocks = [each for branch in block.branches for each in branch.body if isinstance(each, Block)]
        inner += [(each, True) for each in reversed(blocks)] if not is_elsewhere else []
