"""Rule input: files and folders for run time that setup.py does not install in the share directory (SET206, SET207)."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property

from ...languages.python.evaluate.values import GlobResult
from ...light_dataclasses import dataclass
from ...package.file_role import is_set_aside
from ...package.setup.data_files import DataEntry
from ...ros.share_layout import FOLDERS, LAUNCH
from ..started_files import is_started, launches_nothing
from .python_package import PythonPackage
from .share_files import ShareFiles, folder_of


@dataclass(frozen=True)
class UninstalledNeighbour:
    """A file or folder that is not installed, though files next to it are."""

    path: str
    entry: DataEntry
    """The entry that installs the files next to it."""
    glob: GlobResult
    """The glob that matches the installed files."""


@dataclass(frozen=True)
class UninstalledFiles:
    shared: ShareFiles

    @property
    def package(self) -> PythonPackage:
        return self.shared.package

    def useful(self, folder: str) -> tuple[str, ...]:
        """Return the files of a folder that are used at run time, at any depth."""
        last = folder.rpartition("/")[2]
        pattern = FOLDERS.get(last, re.compile(r"[^.].*"))
        files = self.package.files
        found = [
            path
            for path in files.below(folder)
            if pattern.fullmatch(path.rpartition("/")[2]) or is_started(files, path)
        ]
        ignores = files.absent.is_ignored
        found = [path for path in found if not path.endswith("/__init__.py") and "/test/" not in path]
        return tuple(
            path for path in found if not (ignores(path) or (last == "launch" and launches_nothing(files, path)))
        )

    @cached_property
    def folders(self) -> tuple[str, ...]:
        """Folders for run time (`launch`, `config` …) of which nothing is installed, and that no glob names."""
        globbed = {folder_of(glob.pattern).partition("/")[0] for glob in self.package.setup.globs}
        globbed |= {self.shared.suggestion(folder) or folder for folder in globbed}
        modules = {name.partition(".")[0] for name in self.package.setup.package_names}
        return tuple(
            folder
            for folder in FOLDERS
            if folder not in globbed | modules and not self.shared.installs_from(folder) and self.useful(folder)
        )

    @cached_property
    def neighbours(self) -> tuple[UninstalledNeighbour, ...]:
        """Files for run time below the folder of a glob that the glob does not match, and folders without a glob."""
        found: dict[str, UninstalledNeighbour] = {}
        for entry in self.package.setup.data_entries:
            places = {file.setup_text.span for file in entry.files}
            for glob in self.package.setup.globs:
                if glob.span in places and folder_of(glob.pattern):
                    for path in self.missed_below(folder_of(glob.pattern)):
                        found.setdefault(path, UninstalledNeighbour(path, entry, glob))
        for folder, missed in self.sibling_folders():
            found.setdefault(f"{folder}/", missed)
        return tuple(found.values())

    def is_wanted(self, missed: UninstalledNeighbour) -> bool:
        """Return whether something opens a missed file, or its folder, at the path where it would be installed."""
        path, files = missed.path, self.package.files
        name, folder = posixpath.basename(path), posixpath.dirname(path)
        if not name:
            return self.shared.opened.opens_folder(folder)
        if not files.readable_text(path).strip():
            return False
        is_inner = folder != folder_of(missed.glob.pattern) and not LAUNCH.fullmatch(name)
        return self.shared.opened.opens(path) or (is_inner and self.shared.opened.opens_folder(folder))

    def sibling_folders(self) -> Iterator[tuple[str, UninstalledNeighbour]]:
        """Yield folders of which nothing is installed, where at least two sibling folders have a glob each."""
        entries = self.package.setup.data_entries
        globbed = {folder_of(e.glob.pattern): (e, e.glob) for e in entries if e.glob is not None and e.glob.matches}
        for above in {folder.rpartition("/")[0] for folder in globbed} & set(FOLDERS):
            inner = [folder for folder in globbed if folder.rpartition("/")[0] == above]
            for folder in sorted(self.package.files.folders):
                if folder.rpartition("/")[0] == above and len(inner) > 1 and not self.shared.installs_from(folder):
                    useful = [
                        p for p in self.package.files.below(folder) if FOLDERS[above].fullmatch(p.rpartition("/")[2])
                    ]
                    if useful:
                        entry, glob = globbed[inner[-1]]
                        yield folder, UninstalledNeighbour(f"{folder}/", entry, glob)

    def missed_below(self, folder: str) -> Iterator[str]:
        """Yield the files for run time in or below a folder that `data_files` does not install."""
        pattern = FOLDERS.get(folder.partition("/")[0])
        if pattern is None:
            return
        for path in self.package.files.below(folder):
            fits = path not in self.shared.covered and pattern.fullmatch(path.rpartition("/")[2])
            if fits and not is_set_aside(path) and not self.package.files.absent.is_ignored(path):
                yield path
