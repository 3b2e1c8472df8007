"""Commands of ROS 1 in packages that ament builds and that look for nothing of ROS 1."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.workspace import Workspace
from ...ros.read_table import rows

TABLE = "ros1_commands.txt"
BRINGING = ("catkin", "ros1")
"""What packages that may define such commands have in their names."""


@dataclass(frozen=True)
class CommandsOfRos1:
    package: CMakePackage
    workspace: Workspace

    def all(self) -> Iterator[tuple[EvaluatedCommand, str]]:
        """Yield the first certain call of each command, and the one to call instead, "" where there is none."""
        cmake = self.package.cmake
        if not self.package.is_ament or cmake.reads_unknown_files or self.may_bring:
            return
        seen: set[str] = set()
        for call in cmake.calls:
            new = rows(TABLE).get(call.name, ())
            if new and call.name not in seen and not call.maybe and call.name not in cmake.functions:
                seen.add(call.name)
                yield call, new[0].strip("-")

    @property
    def may_bring(self) -> bool:
        """Whether a package is declared, or looked for, that may define such commands."""
        found = (each.name for each in self.package.cmake.packages)
        every = (*found, *(each.name for each in self.package.manifest.dependencies))
        return any(part in name for part in BRINGING for name in every)
