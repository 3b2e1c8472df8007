"""A package that generates interfaces, as far as its manifest has to say so."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from ..ros.interfaces import GROUP
from .cmake.blocks import Block
from .cmake.read import CMakeFile
from .cmake.syntax import Command
from .manifest import Manifest

GENERATE = "rosidl_generate_interfaces"
TESTING = "BUILD_TESTING"
SKIP_INSTALL, SKIP_CHECK = "SKIP_INSTALL", "SKIP_GROUP_MEMBERSHIP_CHECK"
"""Options of the call (rosidl_cmake/cmake/rosidl_generate_interfaces.cmake)."""


@dataclass(frozen=True)
class InterfacePackage:
    manifest: Manifest
    cmake: tuple[CMakeFile, ...]

    @cached_property
    def generates(self) -> tuple[tuple[Command, bool], ...]:
        """Each call that generates interfaces, and whether it stands under `if(BUILD_TESTING)`."""
        found = [pair for file in self.cmake for pair in commands(file.body, False)]
        return tuple((command, test) for command, test in found if command.name == GENERATE)

    @property
    def installs(self) -> bool:
        """Whether interfaces are generated for others than the package's own tests."""
        return any(not test and SKIP_INSTALL not in words(command) for command, test in self.generates)

    @property
    def checks_group(self) -> bool:
        """Whether rosidl looks for the group: unless it is told to skip that, or installs nothing."""
        return any(not words(command) & {SKIP_CHECK, SKIP_INSTALL} for command, _ in self.generates)

    @property
    def is_member(self) -> bool:
        return any(element.text == GROUP for element in self.manifest.all("member_of_group"))


def words(command: Command) -> set[str]:
    return {each.text for each in command.arguments}


def commands(body: list[Command | Block], test: bool) -> Iterator[tuple[Command, bool]]:
    for each in body:
        if isinstance(each, Command):
            yield each, test
            continue
        for branch in each.branches:
            asked = any(TESTING in argument.text for argument in branch.command.arguments)
            yield from commands(branch.body, test or asked)
