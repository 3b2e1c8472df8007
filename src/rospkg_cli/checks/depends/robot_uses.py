"""Undeclared packages whose files and plugins robots, RViz configs and parameter files name (DEP106)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.install_table import InstallTable
from ...package.urdf.robot_file import RobotFile
from ...ros.implied_dependencies import NAVIGATION
from ..urdf.opened_robots import OpenedRobots
from ..urdf.xacro_calls import XacroCalls
from .declared_dependencies import DeclaredDependencies
from .files_in_use import FilesInUse
from .parameter_references import ParameterReferences
from .renamed_packages import RenamedPackages
from .robot_plugins import RobotPlugins
from .robot_references import RobotReferences
from .robot_use import RobotUse
from .undeclared_launch_packages import LaunchDependencies


@dataclass(frozen=True)
class RobotUses:
    declared: DeclaredDependencies
    launch: LaunchDependencies
    robots: tuple[RobotFile, ...]
    table: InstallTable | None
    opened: OpenedRobots
    calls: XacroCalls

    @cached_property
    def used(self) -> FilesInUse:
        return FilesInUse(self.launch, self.robots, self.table, self.opened)

    @cached_property
    def renamed(self) -> RenamedPackages:
        return RenamedPackages(self.launch, self.robots)

    @cached_property
    def plugins(self) -> RobotPlugins:
        return RobotPlugins(self.used)

    def references(self) -> Iterator[tuple[str, RobotUse]]:
        """Yield each package that robots and parameter files need, with the place; some may be declared."""
        parameters = ParameterReferences(self.used, self.renamed)
        yield from RobotReferences(self.used, self.calls).undeclared()
        yield from parameters.found()
        yield from parameters.named()
        yield from parameters.typed()
        yield from self.plugins.all()

    def missing(self) -> dict[str, list[RobotUse]]:
        """Return each package that is named and not declared, without those that launch files use (DEP103)."""
        found: dict[str, list[RobotUse]] = {}
        if self.declared.is_checked:
            reported = self.launch.missing(tests=False)
            for name, use in self.references():
                if name not in reported and not self.declared.has_to_run(name):
                    found.setdefault(name, []).append(use)
        return merged_navigation(found)

    def missing_in_tests(self) -> dict[str, list[RobotUse]]:
        """Return the undeclared packages of plugins in parameter files of tests, where launch files load plugins."""
        found: dict[str, list[RobotUse]] = {}
        if self.declared.is_checked and self.plugins.loads_plugins:
            reported = {*self.launch.missing(tests=False), *self.launch.missing(tests=True), *self.missing()}
            for name, use in self.plugins.all(tests=True):
                if name not in reported and not self.declared.has([name]):
                    found.setdefault(name, []).append(use)
        return merged_navigation(found)


def merged_navigation(found: dict[str, list[RobotUse]]) -> dict[str, list[RobotUse]]:
    """Return what is missing, with the parts of navigation2 put together where several are."""
    parts = [name for name in found if name in NAVIGATION]
    if len(parts) < 2:
        return found
    whole = [use for name in parts for use in found[name]]
    return {name: uses for name, uses in found.items() if name not in NAVIGATION} | {"navigation2": whole}
