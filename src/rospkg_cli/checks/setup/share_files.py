"""Rule input: what a package installs in its share directory, against its files and the references to them."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property
from typing import Annotated

from ...languages.python.evaluate.sandbox_filesystem import MAGIC
from ...languages.python.evaluate.values import GlobResult
from ...light_dataclasses import dataclass
from ...package.file_role import is_set_aside
from ...package.launch.launch_file import LaunchFile
from ...package.setup.data_files import DataEntry, DataFile
from ...package.setup.python_install_table import MARKERS
from ...ros.share_layout import FOLDERS, LAUNCH
from ...suggest import nearest
from ...unreadable import READABLE
from ..opened_in_share import OpenedInShare
from ..repository.pages_and_scripts import FetchedFiles
from ..share_uses import ShareUses
from ..started_files import is_started, launches_nothing
from .python_package import PythonPackage


@dataclass(frozen=True)
class UninstalledNeighbour:
    """A file or folder that is not installed, though files next to it are."""

    path: str
    entry: DataEntry
    """The entry that installs the files next to it."""
    glob: GlobResult
    """The glob that matches the installed files."""


@dataclass(frozen=True)
class ShareFiles:
    package: PythonPackage
    fetched: FetchedFiles | None = None
    launch_files: Annotated[tuple[LaunchFile, ...], READABLE] = ()

    def is_fetched(self, file: DataFile) -> bool:
        """Return whether a page or a script tells to fetch or unpack a missing file, which the build then finds."""
        is_lost = file.source is not None and "*" not in file.source and self.is_missing(file)
        return is_lost and self.fetched is not None and self.fetched.has(file.source or "")

    def is_made(self, file: DataFile) -> bool:
        """Return whether a page or a script has people fetch, make or copy a missing file itself, by its name."""
        is_lost = file.source is not None and "*" not in file.source and self.is_missing(file)
        return is_lost and self.fetched is not None and self.fetched.has_itself(file.source or "")

    @property
    def names(self) -> frozenset[str]:
        """The name in package.xml, and the one in setup.py, which may differ."""
        name = self.package.setup.setup_text("name")
        return frozenset({self.package.name, *([name.text] if name else [])})

    @property
    def installs_marker(self) -> bool:
        wanted = {f"{MARKERS}/{name}" for name in self.names}
        return any(file.destination in wanted for file in self.package.setup.data_files)

    @property
    def installs_manifest(self) -> bool:
        wanted = {f"share/{name}/package.xml" for name in self.names}
        return any(file.destination in wanted for file in self.package.setup.data_files)

    @cached_property
    def markers(self) -> tuple[DataFile, ...]:
        """The files that are installed as markers, whatever their name."""
        files = self.package.setup.data_files
        return tuple(file for file in files if posixpath.dirname(file.destination) == MARKERS)

    def is_missing(self, file: DataFile) -> bool:
        return (
            file.source is not None
            and self.package.setup.kind(file.source) is None
            and not self.package.setup.may_write_files
            and not self.package.files.absent.is_expected(file.source)
        )

    def is_misnamed(self, file: DataFile) -> bool:
        """Return whether a marker has the wrong name that setup.py gives the package."""
        name = self.package.setup.setup_text("name")
        return name is not None and name.text != self.package.name and file.source == f"resource/{name.text}"

    @cached_property
    def covered(self) -> frozenset[str]:
        """The sources that are installed."""
        return frozenset(file.source for file in self.package.setup.data_files if file.source is not None)

    def installs_from(self, folder: str) -> bool:
        return any(f"{source}/".startswith(f"{folder}/") for source in self.covered)

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
    def empty_globs(self) -> tuple[GlobResult, ...]:
        """Globs that match nothing, where nothing else installs files of their folder."""
        found = []
        for glob in self.package.setup.globs:
            folder = folder_of(glob.pattern)
            if glob.matches or not glob.is_certain or self.installs_from(folder) or not folder:
                continue
            if self.package.files.absent.is_expected(glob.pattern):
                continue
            found.append(glob)
        return tuple(dict.fromkeys(found))

    def suggestion(self, folder: str) -> str | None:
        """Return the existing folder with the most similar name; None where the folder exists."""
        folders = self.package.files.folders
        return None if not folder or folder in folders else nearest(folder, folders)

    @cached_property
    def uninstalled_runtime_folders(self) -> tuple[str, ...]:
        """Folders for run time of which nothing is installed and that no glob names."""
        globbed = {folder_of(glob.pattern).partition("/")[0] for glob in self.package.setup.globs}
        globbed |= {self.suggestion(folder) or folder for folder in globbed}
        modules = {name.partition(".")[0] for name in self.package.setup.package_names}
        return tuple(
            folder
            for folder in FOLDERS
            if folder not in globbed | modules and not self.installs_from(folder) and self.useful(folder)
        )

    @cached_property
    def doubles(self) -> tuple[tuple[DataFile, DataFile], ...]:
        """Files that are listed twice: the second and the first. Globs that overlap are harmless."""
        found: list[tuple[DataFile, DataFile]] = []
        seen: dict[str, DataFile] = {}
        globs = {glob.span for glob in self.package.setup.globs}
        index = {*self.markers, *[f for f in self.package.setup.data_files if f.source == "package.xml"]}
        for file in self.package.setup.data_files:
            if file.source is None or file.setup_text.span in globs:
                continue
            first = seen.setdefault(file.source, file)
            if first is not file and (first.destination == file.destination or index & {first, file}):
                found.append((file, first))
        return tuple(found)

    @cached_property
    def uses(self) -> ShareUses:
        own = self.package
        return ShareUses(own.files, own.name, own.workspace, launches=self.launch_files)

    @cached_property
    def opened(self) -> OpenedInShare:
        return OpenedInShare(self.uses)

    @cached_property
    def uninstalled_neighbours(self) -> tuple[UninstalledNeighbour, ...]:
        """Files for run time in or below the folder of a glob that the glob does not match."""
        found: dict[str, UninstalledNeighbour] = {}
        for entry in self.package.setup.data_entries:
            places = {file.setup_text.span for file in entry.files}
            for glob in self.package.setup.globs:
                if glob.span in places and folder_of(glob.pattern):
                    for path in self.uninstalled_below(folder_of(glob.pattern)):
                        found.setdefault(path, UninstalledNeighbour(path, entry, glob))
        for folder, missed in self.uninstalled_folders():
            found.setdefault(f"{folder}/", missed)
        return tuple(found.values())

    def is_wanted(self, missed: UninstalledNeighbour) -> bool:
        """Return whether something opens a file where it would be installed, or the folder that is left out."""
        path, files = missed.path, self.package.files
        name, folder = posixpath.basename(path), posixpath.dirname(path)
        if not name:
            return self.opened.opens_folder(folder)
        if not files.readable_text(path).strip():
            return False
        is_inner = folder != folder_of(missed.glob.pattern) and not LAUNCH.fullmatch(name)
        return self.opened.opens(path) or (is_inner and self.opened.opens_folder(folder))

    def uninstalled_folders(self) -> Iterator[tuple[str, UninstalledNeighbour]]:
        """Yield folders of which nothing is installed, where at least two folders next to them have a glob each."""
        entries = self.package.setup.data_entries
        globbed = {folder_of(e.glob.pattern): (e, e.glob) for e in entries if e.glob is not None and e.glob.matches}
        for above in {folder.rpartition("/")[0] for folder in globbed} & set(FOLDERS):
            inner = [folder for folder in globbed if folder.rpartition("/")[0] == above]
            for folder in sorted(self.package.files.folders):
                if folder.rpartition("/")[0] == above and len(inner) > 1 and not self.installs_from(folder):
                    useful = [
                        p for p in self.package.files.below(folder) if FOLDERS[above].fullmatch(p.rpartition("/")[2])
                    ]
                    if useful:
                        entry, glob = globbed[inner[-1]]
                        yield folder, UninstalledNeighbour(f"{folder}/", entry, glob)

    def uninstalled_below(self, folder: str) -> Iterator[str]:
        pattern = FOLDERS.get(folder.partition("/")[0])
        if pattern is None:
            return
        for path in self.package.files.below(folder):
            fits = path not in self.covered and pattern.fullmatch(path.rpartition("/")[2])
            if fits and not is_set_aside(path) and not self.package.files.absent.is_ignored(path):
                yield path


def folder_of(pattern: str) -> str:
    """Return the folder of a pattern, as far as it is literal."""
    parts = pattern.split("/")
    literal = next((i for i, part in enumerate(parts) if MAGIC.search(part)), len(parts) - 1)
    return "/".join(parts[:literal])
