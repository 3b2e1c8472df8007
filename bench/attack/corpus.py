"""The real packages that attacks begin with, read once."""

from __future__ import annotations

import os
import random
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from .kinds import KINDS, SPARE, kind_of

Files = dict[str, bytes]
AT_MOST = 60
"""Packages of more files are left out: an input is to take a quarter of a second."""
ENOUGH = 16
"""Of a package with more files than that, those around the damage are taken and a few others."""
LARGE = 50_000
ALWAYS = ("package.xml", "setup.py", "setup.cfg", "CMakeLists.txt")


@dataclass
class Corpus:
    """Packages by name, and the places of the files of each kind."""

    packages: dict[str, Files] = field(default_factory=dict)
    places: dict[str, list[tuple[str, str]]] = field(default_factory=dict)

    def texts(self, kind: str) -> list[bytes]:
        """Return every file of a kind, to take pieces from."""
        found = [self.packages[package][path] for package, path in self.places.get(kind, ())]
        return [*found, SPARE[kind]] if kind in SPARE else found


def read_corpus(folders: Iterable[Path]) -> Corpus:
    """Read the small packages below some folders; raises ValueError where there is none."""
    found = Corpus()
    for folder in folders:
        for manifest in sorted(folder.rglob("package.xml")):
            files = read_package(manifest.parent)
            if len(files) <= AT_MOST:
                found.packages[f"{folder.name}/{manifest.parent.relative_to(folder).as_posix()}"] = files
    if not found.packages:
        raise ValueError("there is no package of at most 60 files under the folders that were given")
    for package, files in found.packages.items():
        for path, data in files.items():
            if data and (kind := kind_of(path)) in KINDS and kind:
                found.places.setdefault(kind, []).append((package, path))
    return found


def read_package(folder: Path) -> Files:
    """Return the files of a package by path; what is large (meshes, pictures) is read as empty."""
    found: Files = {}
    for parent, folders, names in os.walk(folder):
        folders.sort()
        for name in sorted(names):
            at = Path(parent, name)
            if at.is_file() and not at.is_symlink():
                path = at.relative_to(folder).as_posix()
                found[path] = b"" if at.stat().st_size > LARGE else at.read_bytes()
    return found


def reduced(files: Files, focus: str, chance: random.Random) -> Files:
    """Return the part of a package that says what it is, the file in focus, and a few others."""
    if len(files) <= ENOUGH:
        return dict(files)
    kept = {path for path in files if path in (*ALWAYS, focus) or PurePosixPath(path).name == "__init__.py"}
    others = sorted(set(files) - kept)
    kept |= set(chance.sample(others, min(len(others), max(ENOUGH - len(kept), 4))))
    return {path: data for path, data in files.items() if path in kept}
