"""A package as somebody sees it who only reads text: its files, and places in them that a pattern finds.

Nothing of the linter is used here, or the bench would share what the linter can't see.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from bench.faults.comments import without_comments
from bench.faults.fault import PutFault, Spot

BUILDABLE = re.compile(r"<build_type[^>]*>\s*(?:ament_|cmake)|<buildtool_depend[^>]*>\s*ament_")
SKIPPED = {".git", "build", "install", "log", "__pycache__", ".github", "COLCON_IGNORE"}
BIGGEST = 300_000
"""Bytes of a text that is read: longer ones are data."""


@dataclass
class SourcePackage:
    repository: Path
    folder: str
    """Below the repository, with `/`; "" where the repository is the package."""
    files: tuple[str, ...]
    """Below the folder; those of packages inside it are left out."""
    siblings: Mapping[str, str] = field(default_factory=dict)
    """Names of all packages of the repository, each with its folder."""
    read: dict[str, tuple[str, str]] = field(default_factory=dict, repr=False)
    """Texts that were read, each with and without comments."""

    @cached_property
    def name(self) -> str:
        return name_in(self.text("package.xml"))

    @cached_property
    def is_python(self) -> bool:
        return "<build_type>ament_python" in re.sub(r"\s", "", self.text("package.xml"))

    def path(self, file: str) -> str:
        return f"{self.folder}/{file}" if self.folder else file

    def data(self, file: str) -> bytes:
        return (self.repository / self.path(file)).read_bytes()

    def text(self, file: str) -> str:
        """Return a file's text; "" if it is absent, long, or no UTF-8."""
        return self.texts(file)[0]

    def texts(self, file: str) -> tuple[str, str]:
        if file not in self.read:
            there = self.repository / self.path(file)
            is_read = file in self.files and there.is_file() and there.stat().st_size <= BIGGEST
            try:
                text = self.data(file).decode() if is_read else ""
            except UnicodeDecodeError:
                text = ""
            self.read[file] = text, without_comments(file, text)
        return self.read[file]

    def matching(self, files: str) -> list[str]:
        """Return the files whose path inside the package holds a pattern."""
        pattern = re.compile(files)
        return [file for file in self.files if pattern.search(file)]

    def spots(self, files: str, pattern: str, group: int = 1, flags: int = re.MULTILINE) -> Iterator[Spot]:
        """Yield the places where a pattern is found outside comments."""
        compiled = re.compile(pattern, flags)
        for file in self.matching(files):
            text, bare = self.texts(file)
            for match in compiled.finditer(bare):
                if match.start(group) >= 0:
                    yield Spot(self.path(file), text, match, group)

    def holds(self, files: str, pattern: str) -> bool:
        return next(self.spots(files, pattern, 0), None) is not None

    def words(self, files: str, pattern: str) -> set[str]:
        return {spot.word for spot in self.spots(files, pattern)}

    def removed(self, file: str, *names: str) -> PutFault:
        return PutFault(self.path(file), (file.rsplit("/", 1)[-1], *names), {self.path(file): None})

    def renamed(self, file: str, new: str, *names: str) -> PutFault:
        """Return the fault of a file that lies under another name; both are given as path inside the package."""
        old_name, new_name = file.rsplit("/", 1)[-1], new.rsplit("/", 1)[-1]
        files = {self.path(file): None, self.path(new): self.data(file)}
        return PutFault(self.path(file), (old_name, new_name, *names), files)


def name_in(manifest: str) -> str:
    found = re.search(r"<name>\s*([\w-]+)\s*</name>", manifest)
    return found[1] if found else ""


def packages_of(repository: Path) -> list[SourcePackage]:
    """Return the packages for ROS 2 of a checkout, sorted by folder."""
    by_folder: dict[str, list[str]] = {}
    for top, folders, names in os.walk(repository):
        if "COLCON_IGNORE" in names or "AMENT_IGNORE" in names:
            folders.clear()
            continue
        folders[:] = sorted(set(folders) - SKIPPED)
        at = Path(top).relative_to(repository).as_posix()
        home = "" if at == "." else at
        if "package.xml" in names:
            by_folder[home] = []
        owner = next((f for f in ancestors(home) if f in by_folder), None)
        if owner is not None:
            prefix = home[len(owner) :].strip("/")
            by_folder[owner] += [f"{prefix}/{name}" if prefix else name for name in sorted(names)]
    found = [SourcePackage(repository, folder, tuple(files)) for folder, files in sorted(by_folder.items())]
    siblings = {each.name: each.folder for each in found}
    for each in found:
        each.siblings = siblings
    return [each for each in found if each.name and BUILDABLE.search(each.text("package.xml"))]


def ancestors(folder: str) -> Iterator[str]:
    while folder:
        yield folder
        folder = folder.rpartition("/")[0]
    yield ""
