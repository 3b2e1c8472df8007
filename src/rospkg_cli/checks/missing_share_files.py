"""Rule input: files that code looks for in share directories, and that are not installed there."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ..files import PackageFiles
from ..languages.cpp.file import CppFile
from ..languages.python.file import PythonFile
from ..languages.python.joined_paths import PathJoiner
from ..languages.python.unreached_places import is_unreached
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.file_role import role_of
from ..package.install_table import InstallTable
from ..package.launch.file_references import is_file
from ..package.package_facts import PackageFacts
from ..package.python.share_paths import share_of
from ..package.workspace import Workspace
from ..source import Span
from .cpp.share_file_paths import share_file_paths
from .install_faults import InstallFaults
from .paths.closest_path import closest_path
from .python.run_imports import RunImports
from .share_lookup_calls import looking_up

LOOKS_FIRST = frozenset(
    {"exists", "isfile", "is_file", "isdir", "is_dir", "FileNotFoundError", "makedirs", "mkdir", "create_director"}
)
WRITERS = regex(r"\b(?:to_csv|savetxt|savez?|dump|imwrite|writer?|ofstream)\b")
"""Calls that write a file of data."""


@dataclass(frozen=True, slots=True)
class MissingShareFile:
    path: str
    span: Span
    package: str
    file: str
    """Relative to the share directory."""
    near: str | None
    is_here: bool
    """Whether the package has the file, and does not install it there."""
    goes_to: str | None = None
    """Where below the prefix it is installed instead."""


@dataclass(frozen=True)
class MissingShareFiles:
    run: RunImports
    files: PackageFiles
    facts: PackageFacts
    workspace: Workspace
    faults: InstallFaults
    sources: tuple[CppFile, ...] = ()
    table: InstallTable | None = None

    def found(self) -> Iterator[MissingShareFile]:
        for file in looking_up(self.run):
            if looks_first(file):
                continue
            for found in PathJoiner(file, share_of).paths():
                path = posixpath.normpath(found.text.lstrip("/"))
                if found.text.startswith("/") and (facts := self.facts_of(found.base)) is not None:
                    missing = self.missing(file.path, file.span(found.node), facts, path)
                    if missing is not None and not is_unreached(file, missing.span):
                        yield missing
        for source in self.sources:
            if role_of(source.path) == "run" and not looks_first(source):
                for named in share_file_paths(source):
                    if (facts := self.facts_of(named.package)) is not None:
                        path = posixpath.normpath(named.file.lstrip("/"))
                        missing = self.missing(source.path, named.span, facts, path)
                        yield from [missing] if missing is not None else []

    def facts_of(self, name: str) -> PackageFacts | None:
        return self.facts if name == self.facts.name else self.workspace.named(name)

    def missing(self, where: str, span: Span, facts: PackageFacts, path: str) -> MissingShareFile | None:
        """Return a file or folder that is not installed; None where code may write it, or another rule reports it.

        A file that looks like an output, and that the package has, counts unless the code at `where` writes files.
        """
        is_own = facts is self.facts
        is_here = is_own and (self.files.is_there(path) or path in self.files.folders)
        is_read = is_here and not WRITERS.search(self.files.readable_text(where))
        if not (is_read or is_file(path)) or not path.isprintable() or path.startswith(".."):
            return None
        if not facts.knows("share_files") or path in facts.share_files or facts.may_write(path):
            return None
        below = (*facts.share_files, *facts.uninstalled, *facts.run_time_files) if is_here else ()
        if path in facts.run_time_files or any(each.startswith(f"{path}/") for each in below):
            return None
        if path in facts.uninstalled and (not is_read or self.faults.is_reported(facts.name, path)):
            return None
        near = None if is_here else closest_path(path, facts.share_files)
        if not is_here and (not near or (facts is self.facts and self.files.absent.is_expected(path))):
            return None
        goes_to = self.table.destination_of(path) if is_here and self.table is not None else None
        if goes_to and self.faults.is_reported_at_destination(facts.name, goes_to):
            return None
        return MissingShareFile(where, span, facts.name, path, near, is_here, goes_to)


def looks_first(file: PythonFile | CppFile) -> bool:
    """Return whether code checks whether a file exists, makes its folder, or catches that it is missing."""
    return any(name in file.source.text for name in LOOKS_FIRST)
