"""Which robots and parameter files of a package are installed and opened, and which packages launch files start."""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.file_role import LAUNCH, role_of
from ...package.install_table import InstallTable
from ...package.urdf.robot_file import RobotFile
from ..launch.package_references import every_reference
from ..urdf.opened_robots import OpenedRobots
from .opened_parameters import OpenedParameters
from .undeclared_launch_packages import LaunchDependencies


@dataclass(frozen=True)
class FilesInUse:
    launch: LaunchDependencies
    robots: tuple[RobotFile, ...]
    table: InstallTable | None
    opened: OpenedRobots

    @property
    def files(self) -> PackageFiles:
        return self.launch.files

    def is_used(self, path: str) -> bool:
        """Return whether a file is installed, or may be; files of tests are not."""
        if role_of(path) == "test":
            return False
        if self.table is None or not self.table.knows("share") or LAUNCH.search(path):
            return True
        return path in self.sources

    @cached_property
    def sources(self) -> frozenset[str]:
        """The files that are installed."""
        return frozenset(row.source for row in self.table.rows) if self.table else frozenset()

    @cached_property
    def started(self) -> frozenset[str]:
        """The packages whose nodes or files the launch files use."""
        uses = (use for file in self.launch.launch_files for use in every_reference(file))
        return frozenset(use.name for use in uses if use.fails != "controller")

    @cached_property
    def parameters(self) -> OpenedParameters:
        """The parameter files that launch files, or robots in use, open."""
        opened = tuple(each for each in self.robots if self.is_used(each.path) and self.opened.has(each.path))
        launches = tuple(self.launch.launch_files)
        declared = self.launch.declared
        return OpenedParameters(declared.facts, declared.workspace, launches, opened, self.files)
