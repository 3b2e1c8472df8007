"""Launch files that no rule installs though it lists all others, or that are installed where nothing finds them."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.file_role import role_of
from ...package.install_table import InstalledFile, InstallTable
from .named_paths import INSTALLERS, paths_of
from .runtime_files import LAUNCH
from .share_folders import RuntimeFolders

FEW = 2
"""Launch files that don't show what is done with a third one."""
STRAY = f"share/{LAUNCH}/"
"""Where launch files are never found, whatever else is installed."""


@dataclass(frozen=True)
class LaunchFileInstalls:
    folders: RuntimeFolders

    @property
    def package(self) -> CMakePackage:
        return self.folders.package

    @property
    def table(self) -> InstallTable:
        return self.folders.table

    def left_out(self) -> Iterator[tuple[str, InstalledFile]]:
        """Yield the one launch file that is not installed where rules list all others of the folder, with one of them.

        What a launch file names is reported there.
        """
        useful = self.folders.useful(LAUNCH) if self.folders.is_clear else ()
        files = [path for path in useful if posixpath.dirname(path) == LAUNCH]
        listed = {text for rule in self.package.cmake.installs if rule.kind == "FILES" for text in rule.call.texts}
        rows = {row.source: row for row in self.table.rows if row.source in files}
        lost = [path for path in files if path not in rows]
        if len(lost) == 1 and len(files) > FEW and all(path in listed for path in rows):
            name, text_of = posixpath.basename(lost[0]), self.package.cmake.package_files.readable_text
            texts = (*map(text_of, files), *(file.source.text for file in self.folders.launch_files))
            if not any(name in text for text in texts) and lost[0] not in self.named_paths:
                yield lost[0], next(iter(rows.values()))

    @cached_property
    def named_paths(self) -> frozenset[str]:
        calls = (call for call in self.package.cmake.calls if call.name not in INSTALLERS)
        return frozenset(path for call in calls for path in paths_of(call))

    def misplaced(self) -> InstalledFile | None:
        """Return the first launch file that is installed, where none is below share/ and the package's name.

        Absolute places, and those below the name that project() has by mistake, are reported by other rules.
        """
        files = self.folders.useful(LAUNCH)
        rows = [row for row in self.table.rows if row.source in files]
        if not (self.folders.is_clear and self.table.knows("other")):
            rows = [row for row in rows if row.destination.startswith(STRAY)]
        known = ("/", *(f"share/{name}/" for name in (self.package.facts.name, self.package.cmake.project_name)))
        if any(self.is_reported(row) for row in rows):
            return None
        unclear = (row for row in rows if row.maybe and not row.destination.startswith(STRAY))
        is_found = any(row.destination.startswith(known) for row in rows) or next(unclear, None) is not None
        return rows[0] if rows and not is_found else None

    def is_reported(self, misplaced: InstalledFile) -> bool:
        """Return whether a launch file of the package names what the same command installs, which LCH004 reports."""
        calls = [rule.call for rule in self.package.cmake.installs if rule.call.path == misplaced.path]
        spans = (call.command.span for call in calls)
        whole = next((each for each in spans if each.holds(misplaced.span)), misplaced.span)
        together = (row for row in self.table.rows if row.path == misplaced.path)
        sources = {row.source for row in together if whole.holds(row.span)}
        files = (file for file in self.folders.launch_files if role_of(file.path) == "launch" and not file.is_ros1)
        return any(
            each.package == self.package.facts.name and each.path in sources for file in files for each in file.paths
        )
