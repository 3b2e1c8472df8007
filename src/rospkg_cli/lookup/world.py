"""The packages of a workspace, for looking up: read again only where their files changed."""

from __future__ import annotations

from collections.abc import Set

from ..files import PackageFiles
from ..light_dataclasses import dataclass, field
from ..package.install_table import InstalledFile, InstallTable
from ..package.package_facts import NOWHERE, PackageFacts
from ..package.workspace import Workspace
from ..source import Source, Span
from ..tree import Tree
from .lookup_package import LookupPackage


@dataclass(frozen=True)
class DefinitionSite:
    """A span of a file; the path is relative to the root of the tree."""

    path: str
    span: Span


@dataclass
class LookupWorld:
    tree: Tree
    workspace: Workspace
    _packages: dict[str, LookupPackage] = field(default_factory=dict, init=False, repr=False)

    def package(self, folder: str) -> LookupPackage:
        """Return the package in a folder."""
        if folder not in self._packages:
            self._packages[folder] = LookupPackage(PackageFiles(self.tree.sub(folder), folder, self.tree))
        return self._packages[folder]

    def keep(self, other: LookupWorld, changed: Set[str | None]) -> None:
        """Take over what another world of the same packages has read, but for those in some folders."""
        self._packages |= {folder: package for folder, package in other._packages.items() if folder not in changed}

    def facts(self, name: str, folder: str) -> PackageFacts | None:
        """Return the facts of a named package; of the one in a folder where no name is given."""
        if name:
            return self.workspace.named(name)
        return next((each for each in self.workspace.packages if each.folder == folder), None)

    def rows(self, facts: PackageFacts) -> tuple[InstalledFile, ...]:
        """Return what a package installs, as far as that is known."""
        table = self.package(facts.folder).parts(InstallTable).only
        return table.rows if table else ()

    def place(self, facts: PackageFacts, path: str, span: Span = NOWHERE) -> DefinitionSite | None:
        """Return a place in a file of a package; None where there is no such file."""
        whole = facts.at(path).lstrip("/")
        return DefinitionSite(whole, span) if path in self.package(facts.folder).files.paths else None

    def source(self, path: str) -> Source:
        """Return the text of a path from the root; an empty one where it has none."""
        try:
            return Source(path, self.tree.entry(path).text.text)
        except (OSError, UnicodeError):
            return Source(path, "")
