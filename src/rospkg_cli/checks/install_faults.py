"""Files that rules on install rules report, so that rules on their use need not report them again."""

from __future__ import annotations

from functools import cached_property

from ..light_dataclasses import dataclass
from ..package.cmake.cmake_project import CMake
from ..package.package_facts import PackageFacts
from ..package.setup.setup_py import SetupPy
from ..package.workspace import Workspace
from .cmake.share_folders import RuntimeFolders
from .setup.data_destinations import DataDestinations
from .setup.left_out_files import left_out
from .setup.share_files import ShareFiles, folder_of
from .setup.uninstalled_files import UninstalledFiles


@dataclass(frozen=True)
class InstallFaults:
    package: PackageFacts
    workspace: Workspace
    cmake: CMake | None
    uninstalled: UninstalledFiles | None
    folders: RuntimeFolders | None

    @property
    def shared(self) -> ShareFiles | None:
        return self.uninstalled.shared if self.uninstalled is not None else None

    @property
    def setup(self) -> SetupPy | None:
        return self.shared.package.setup if self.shared is not None and self.cmake is None else None

    def is_reported(self, package: str, path: str) -> bool:
        """Return whether a rule reports that a package does not install a file of its share directory."""
        top = path.partition("/")[0]
        if package == self.package.name:
            return any(path.startswith(f"{folder}/") for folder in self.reported_folders) or path in self.reported_files
        facts = self.workspace.named(package)
        given = facts is not None and facts.folder in self.workspace.selected
        return given and facts is not None and not any(each.startswith(f"{top}/") for each in facts.share_files)

    def is_reported_at_destination(self, package: str, place: str) -> bool:
        """Return whether SET208 reports what setup.py installs to a place, or CMK111 that CMake's is absolute."""
        if place.startswith("/"):
            return self.cmake is not None and package == self.package.name
        shared = self.shared if self.setup is not None and package == self.package.name else None
        entries = DataDestinations(shared).misplaced if shared is not None else ()
        return any(place.startswith(f"{entry.folder}/") for entry, _, _ in entries)

    @cached_property
    def reported_folders(self) -> frozenset[str]:
        """The folders of which nothing is installed, and those of globs without a match, as written and corrected."""
        found = set(self.folders.uninstalled()) if self.folders is not None and self.cmake is not None else set()
        if self.setup is not None and self.shared is not None and self.uninstalled is not None:
            empty = {folder_of(glob.pattern) for glob in self.shared.empty_globs}
            corrected = (self.shared.suggestion(folder) for folder in empty)
            found |= {*self.uninstalled.folders, *empty, *filter(None, corrected)}
        return frozenset(found)

    @cached_property
    def reported_files(self) -> frozenset[str]:
        """The files next to those that a glob finds or that are listed, and all in the folders next to them."""
        if self.folders is not None and self.cmake is not None:
            from .cmake.launch_file_installs import LaunchFileInstalls  # few packages are built with CMake

            return frozenset(path for path, _ in LaunchFileInstalls(self.folders).left_out())
        if self.setup is None or self.uninstalled is None:
            return frozenset()
        next_to = {each.path for each in self.uninstalled.neighbours}
        next_to |= {path for path, _ in left_out(self.uninstalled)}
        inside = (path for folder in next_to for path in self.uninstalled.package.files.below(folder))
        return frozenset(next_to.union(inside))
