"""Rule input: the files that `data_files` of setup.py installs, and those that it lists in vain."""

from __future__ import annotations

import posixpath
from functools import cached_property
from typing import Annotated

from ...languages.python.evaluate.sandbox_filesystem import MAGIC
from ...languages.python.evaluate.values import GlobResult
from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...package.setup.data_files import DataFile
from ...package.setup.python_install_table import MARKERS
from ...suggest import nearest
from ...unreadable import READABLE
from ..opened_in_share import OpenedInShare
from ..repository.pages_and_scripts import FetchedFiles
from ..share_uses import ShareUses
from .python_package import PythonPackage


@dataclass(frozen=True)
class ShareFiles:
    package: PythonPackage
    fetched: FetchedFiles | None = None
    launch_files: Annotated[tuple[LaunchFile, ...], READABLE] = ()

    def is_fetched(self, file: DataFile) -> bool:
        """Return whether a page or a script fetches or unpacks a missing file, so that the build finds it."""
        is_lost = file.source is not None and "*" not in file.source and self.is_missing(file)
        return is_lost and self.fetched is not None and self.fetched.has(file.source or "")

    def is_made(self, file: DataFile) -> bool:
        """Return whether a page or a script says to fetch, make or copy a missing file, by its name."""
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
        """Return whether a marker is named as the package in setup.py, where package.xml has another name."""
        name = self.package.setup.setup_text("name")
        return name is not None and name.text != self.package.name and file.source == f"resource/{name.text}"

    @cached_property
    def covered(self) -> frozenset[str]:
        """The sources that are installed."""
        return frozenset(file.source for file in self.package.setup.data_files if file.source is not None)

    def installs_from(self, folder: str) -> bool:
        return any(f"{source}/".startswith(f"{folder}/") for source in self.covered)

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
    def doubles(self) -> tuple[tuple[DataFile, DataFile], ...]:
        """Files that are listed twice: the second and the first place. Globs that overlap are harmless."""
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


def folder_of(pattern: str) -> str:
    """Return the folder of a pattern, as far as it is literal."""
    parts = pattern.split("/")
    literal = next((i for i, part in enumerate(parts) if MAGIC.search(part)), len(parts) - 1)
    return "/".join(parts[:literal])
