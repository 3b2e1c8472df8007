"""The packages around the one that is written: those of its workspace, and those that are written with it."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from pathlib import Path

from ..disk import DiskTree
from ..engine.discovery.discover import packages_below
from ..engine.discovery.incomplete_workspace import missing_packages
from ..engine.discovery.installed_packages import installed_package_names
from ..files import PackageFiles
from ..index import NamesError
from ..index.cache import names
from ..light_dataclasses import dataclass, field, replace
from ..package.collect_facts import collect_facts
from ..package.launch.launch_file import LaunchFile
from ..package.manifest import Manifest
from ..package.package import Package
from ..package.package_facts import PackageFacts
from ..ros.distros import Targets
from ..ros.names import BUILT_IN, Names
from ..tree import MemoryTree, Tree
from ..unreadable import UnreadableError


@dataclass(frozen=True)
class Neighbour:
    """A package that is there, or will be."""

    package: Package

    @cached_property
    def facts(self) -> PackageFacts:
        return collect_facts(self.package, Targets(), self.package.folder, self.package.folder)

    @property
    def launch_files(self) -> dict[str, frozenset[str]]:
        """The arguments of each launch file that is installed in `launch/`, by the file's name."""
        read = {file.path: file for file in self.package.parts(LaunchFile).good}
        paths = [path for path in sorted(self.facts.share_files) if path.startswith("launch/") and path in read]
        return {path.removeprefix("launch/"): frozenset(arguments_of(read[path])) for path in paths}

    def text(self, path: str) -> str:
        """Return the text of a file that is installed in share/; "" where there is none."""
        if path not in self.facts.share_files or not self.package.files.exists(path):
            return ""
        try:
            return self.package.files.source(path).text
        except UnreadableError:
            return ""


def arguments_of(file: LaunchFile) -> Iterator[str]:
    for argument in file.arguments:
        if argument.name.literal is not None:
            yield argument.name.literal


@dataclass(frozen=True)
class WorkspacePackages:
    trees: Mapping[str, Tree] = field(default_factory=dict)
    """Each package's files, by its name."""
    installed: frozenset[str] = frozenset()
    """The names of packages that are installed on this machine."""
    complete: bool = True
    """Whether nothing says that more packages belong to the workspace than are there."""
    index: Names = BUILT_IN
    """The names of the world outside."""

    def with_package(self, name: str, tree: MemoryTree) -> WorkspacePackages:
        return replace(self, trees={**self.trees, name: tree})

    def without(self, name: str) -> WorkspacePackages:
        return replace(self, trees={each: tree for each, tree in self.trees.items() if each != name})

    def named(self, name: str) -> Neighbour | None:
        return Neighbour(self.package(name)) if name in self.trees else None

    def package(self, name: str) -> Package:
        """Return a package; raises KeyError."""
        return Package(PackageFiles(self.trees[name], name))


def workspace_packages(into: Path) -> WorkspacePackages:
    """Return the packages below the nearest `src` that holds a folder; where there is none, those in the folder."""
    trees: dict[str, Tree] = {}
    folders = list(package_folders(into.absolute()))
    for folder in folders:
        tree = DiskTree(folder)
        manifest = Package(PackageFiles(tree, folder.name)).parts(Manifest).only
        trees.setdefault((manifest.name if manifest else "") or folder.name, tree)
    complete = not missing_packages(None, [*folders, into.absolute()]).why
    return WorkspacePackages(trees, installed_package_names(os.environ), complete, fetched_names(os.environ))


def fetched_names(environment: Mapping[str, str]) -> Names:
    """Return the names that were fetched; those that are built in where there are none, or none that can be read."""
    try:
        return names(environment)
    except NamesError:
        return BUILT_IN


def package_folders(into: Path) -> Iterable[Path]:
    for folder in (into, *into.parents):
        if folder.name == "src":
            return packages_below(folder)
    return sorted(each.parent for each in into.glob("*/package.xml"))
