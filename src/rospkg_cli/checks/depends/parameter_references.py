"""The packages that parameter files name: `$(find-pkg-share …)`, `package://…` and types of interfaces."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...ros.names import NameKind
from .brought_dependencies import brought_by
from .declared_dependencies import DeclaredDependencies
from .files_in_use import FilesInUse
from .found_by_parameters import found_by_parameters, named_by_parameters, typed_by_parameters
from .renamed_packages import RenamedPackages
from .robot_use import RobotUse, unopened

LOADS_TYPES = frozenset({"joy_teleop"})
"""Packages whose nodes load interfaces by the names in their parameters."""


@dataclass(frozen=True)
class ParameterReferences:
    used: FilesInUse
    renamed: RenamedPackages

    @property
    def declared(self) -> DeclaredDependencies:
        return self.used.launch.declared

    def found(self) -> Iterator[tuple[str, RobotUse]]:
        """Yield the packages that installed parameter files look for: `$(find-pkg-share …)`.

        Launch replaces these with `allow_substs` alone, so they are optional. Launch files in YAML are left out.
        """
        launches = {file.path for file in self.used.launch.launch_files}
        for name, path, span in found_by_parameters(self.used.files):
            is_known = self.declared.workspace.kind_of(name) is NameKind.PACKAGE
            if path not in launches and is_known and self.used.is_used(path):
                yield name, RobotUse(path, span, "and its files are named here", "they are not found", True)

    def named(self) -> Iterator[tuple[str, RobotUse]]:
        """Yield the unknown packages whose files installed parameter files name, and a package here has."""
        for name, _, path, span in named_by_parameters(self.used.files):
            if name != self.declared.facts.name and self.used.is_used(path) and self.renamed.owner_of(name)[0]:
                use = RobotUse(path, span, "and its files are named here", "they are not found")
                yield name, use if self.used.parameters.may_have(path) else unopened(use)

    def typed(self) -> Iterator[tuple[str, RobotUse]]:
        """Yield the packages of interfaces that installed parameter files have a node load: `interface_type: …`.

        They are optional unless launch files start such a node, and where they come with it.
        """
        for name, interface, path, span in typed_by_parameters(self.used.files):
            if self.declared.workspace.kind_of(name) is NameKind.PACKAGE and self.used.is_used(path):
                loading = LOADS_TYPES & self.used.started
                is_optional = not loading or not self.used.parameters.may_have(path)
                is_optional = is_optional or name in brought_by(sorted(loading), self.declared.workspace)
                usage = f"and its type `{interface}` is named here"
                yield name, RobotUse(path, span, usage, "the node can't load it", is_optional)
