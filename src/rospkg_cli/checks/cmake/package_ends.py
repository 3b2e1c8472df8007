"""Packages whose last command is a macro of another package, which may call `ament_package()` (CMK003)."""

from __future__ import annotations

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.targets import MAKERS
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.cmake_project import CMake
from ...package.cmake.foreign_commands import OF_OPTIONS, unfamiliar_commands
from ...package.workspace import Workspace
from .known_packages import is_known_package, may_define
from .unknown_commands import RESERVED, UnknownCommands

BEFORE_ENDS = regex(r"install|rosidl_\w+|pluginlib_\w+|rclcpp_components_\w+|ament_(?!lint)\w+|generate_parameter\w*")
"""Commands that have no use after `ament_package()`, in addition to those that make targets."""


@dataclass(frozen=True)
class PackageEnds:
    """Rule input: a package of CMake, and what is known of the packages that it finds."""

    package: CMakePackage
    workspace: Workspace

    @property
    def may_be_elsewhere(self) -> bool:
        """Whether a macro that another package has is called behind all that makes, installs or exports something."""
        cmake = self.package.cmake
        slips = {call.name for call, _ in UnknownCommands(cmake).all()}
        last = max((cmake.last_index(call.command) for call in cmake.calls if comes_before(call)), default=-1)
        foreign = (each for each in unfamiliar_commands(cmake) if not OF_OPTIONS.fullmatch(each.name))
        late = {each.name for each in foreign if cmake.last_index(each.command) > last} - slips
        return any(self.may_be_found(name, cmake) for name in late)

    def may_be_found(self, command: str, cmake: CMake) -> bool:
        """Return whether a package may have a command: it begins like it, or the package is not known."""
        found = {each.name for each in cmake.packages}
        vendors = {name.lower().partition("_")[0] for name in found}.difference(RESERVED)
        if command.partition("_")[0] in vendors:
            return True
        here = (self.workspace.named(name) for name in found)
        return not all(is_known_package(name, self.workspace) for name in found) or any(map(may_define, here))


def comes_before(call: EvaluatedCommand) -> bool:
    return not call.testing and (call.name in MAKERS or BEFORE_ENDS.fullmatch(call.name) is not None)
