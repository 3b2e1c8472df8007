"""Rule input: whether a file that a robot names is in the share directory of its package, and where it is if not."""

from __future__ import annotations

import posixpath
from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.install_table import InstallTable
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.share_layout import FOLDERS
from ..install_faults import InstallFaults
from ..paths.closest_path import closest_path
from ..repository.pages_and_scripts import ARCHIVES
from .missing_resource import State


@dataclass(frozen=True)
class ShareResources:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace
    install: InstallFaults
    table: InstallTable | None

    def facts_of(self, package: str) -> PackageFacts | None:
        """Return what is known of a package; None for one outside the workspace."""
        return self.package if package == self.package.name else self.workspace.named(package)

    def is_expected(self, facts: PackageFacts, path: str) -> bool:
        """Return whether a build writes a file, git ignores it, or a submodule may hold it."""
        if facts is self.package:
            return facts.may_write(path) or self.is_made(path)
        return facts.may_write(path) or self.files.absent_in(facts.folder).is_ignored(path)

    def is_made(self, path: str) -> bool:
        """Return whether a file of this package is not there, but git ignores it or a submodule may hold it."""
        is_there = self.files.exists(path) or path in self.files.folders
        return not is_there and self.files.absent.is_expected(path)

    def state(self, facts: PackageFacts, path: str) -> State | None:
        """Return why a file or folder is not at its path in the share directory; None where it is, or may be."""
        if path in facts.share_files or path in self.share_folders(facts):
            return None
        if facts is not self.package or not (self.files.exists(path) or path in self.files.folders):
            if path in facts.uninstalled:
                return "not installed"
            return "absent" if path not in facts.run_time_files else None
        if self.goes_to(path):
            return "elsewhere" if facts.knows("share_files") else None
        top = path.partition("/")[0]
        partly = "/" not in path or top in self.share_folders(facts) or top not in FOLDERS
        return "not installed" if partly and facts.knows("share_files") else None

    def goes_to(self, path: str) -> str | None:
        """Return where a file of this package is installed, relative to the install prefix; None where it is not."""
        return self.table.destination_of(path) if self.table is not None else None

    def is_reported(self, facts: PackageFacts, path: str, state: State) -> bool:
        """Return whether another rule reports why a file is not installed, or that it is installed elsewhere."""
        place = (self.goes_to(path) or "") if state == "elsewhere" else ""
        is_misplaced = bool(place) and self.install.is_reported_at_destination(facts.name, place)
        return is_misplaced or (state != "absent" and self.install.is_reported(facts.name, path))

    def share_folders(self, facts: PackageFacts) -> frozenset[str]:
        """Return the folders in the share directory of a package."""
        return self._own_folders if facts is self.package else folders_of(facts.share_files)

    @cached_property
    def _own_folders(self) -> frozenset[str]:
        return folders_of(self.package.share_files)

    def missing_folder(self, facts: PackageFacts, path: str) -> str:
        """Return the outermost folder of a path that a package does not have; "" where it has all of them."""
        known = self.share_folders(facts) | (self.files.folders if facts is self.package else frozenset())
        parts = path.split("/")
        above = ("/".join(parts[:end]) for end in range(1, len(parts)))
        return next((folder for folder in above if folder not in known), "")

    def closest(self, facts: PackageFacts, path: str) -> str | None:
        """Return the path of a package that is closest to one that it does not have; None where none is close."""
        known = set(facts.share_files) | (set(self.files.paths) if facts is self.package else set())
        return closest_path(path, {each for each in known if not each.endswith(ARCHIVES)})


def folders_of(paths: frozenset[str]) -> frozenset[str]:
    """Return all folders above some files."""
    found = set()
    for path in paths:
        while path := posixpath.dirname(path):
            found.add(path)
    return frozenset(found)
