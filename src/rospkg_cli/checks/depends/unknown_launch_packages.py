"""Packages that launch files name and that are known nowhere: which name was intended, or where they come from."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.launch.launch_file import LaunchFile
from ...ros.names import NameKind
from ...suggest import begins_alike, is_misspelt, nearest
from .declared_dependencies import DeclaredDependencies

if TYPE_CHECKING:
    from .fetched_repositories import FetchedRepositories

OF_VARIABLES = regex(r"_(?:dir|path|pkg|package|share)$")
"""What follows the name of a package in the name of a variable that holds it, or its folder: `nav_dir`."""


@dataclass(frozen=True)
class UnknownLaunchPackages:
    declared: DeclaredDependencies
    files: PackageFiles
    launch_files: tuple[LaunchFile, ...]
    cmake: CMake | None

    def has(self, name: str) -> bool:
        """Return whether no package of that name is known."""
        workspace = self.declared.workspace
        return not workspace.is_available(name) and workspace.kind_of(name) not in (NameKind.PACKAGE, NameKind.KEY)

    def is_fetched(self, name: str) -> bool:
        """Return whether a README links to the repository of an unknown package, or a page or a script fetches it."""
        return self.has(name) and self.fetched.may_have(name)

    @cached_property
    def fetched(self) -> FetchedRepositories:
        from .fetched_repositories import FetchedRepositories  # most packages are known

        return FetchedRepositories(self.files, self.declared.workspace, self.declared.otherwise.hidden)

    def intended(self, name: str) -> str | None:
        """Return the known package whose name was intended; None where the name may be that of another package.

        A name with another first letter or another word (`acme_lidar`, `acme_camera`) is that of another package; one
        with the `_dir` of a variable (`nav_dir`) is not.
        """
        if not self.has(name) or self.declared.workspace.is_listed(name):
            return None
        if self.declared.otherwise.hidden.folder_of(name) or self.fetched.has_cloned(name):
            return None
        if self.cmake is not None and name == self.cmake.project_name:
            return self.declared.facts.name
        near = nearest(name, self.known_names)
        is_same = near is not None and (is_misspelt(name, near) or OF_VARIABLES.sub("", name) == near)
        is_intended = near is not None and is_same and begins_alike(name, near)
        return near if is_intended else self.having_what_is_started(name)

    def having_what_is_started(self, name: str) -> str | None:
        """Return the one package of the workspace that installs all executables that launch files start of another."""
        programs = (found for file in self.launch_files for found in file.programs())
        started = {executable.literal or "" for package, executable, _ in programs if package == name}
        having = [each.name for each in self.declared.workspace.packages if started <= each.executables]
        return having[0] if started and len(having) == 1 else None

    @property
    def known_names(self) -> frozenset[str]:
        """The packages of the workspace and those that are declared."""
        return self.declared.workspace.names | self.declared.names
