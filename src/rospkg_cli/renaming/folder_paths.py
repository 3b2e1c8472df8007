"""Where files name a folder that moves by a path: .gitignore and its like, workflows, scripts, `../` in CMake."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator, Mapping

from ..files import folders_of
from ..light_dataclasses import dataclass
from ..source import Span

LISTS = frozenset({".gitignore", ".dockerignore", ".gitattributes", "CODEOWNERS", "MANIFEST.in"})
"""Files with a path, or a pattern of paths, in each line."""


@dataclass(frozen=True)
class MovedFolders:
    """The files of a workspace before, and those paths among them that get the new name; all from the root."""

    name: str
    moves: Mapping[str, str]
    files: frozenset[str]
    folders: frozenset[str]


def moved_folders(name: str, moves: Mapping[str, str], files: Iterable[str]) -> MovedFolders:
    every = frozenset(files)
    return MovedFolders(name, moves, every, folders_of(every))


def folder_paths(text: str, path: str, moved: MovedFolders) -> Iterator[Span]:
    """Yield the name in each path of a file that leads to something which moves; `path` is that of the file.

    A path begins at the root, or in the folder of the file. In other files than lists it has to exist.
    """
    folder, _, file = path.rpartition("/")
    is_list = file in LISTS
    for match in re.finditer(r"(?<![\w:.-])/?(?P<path>(?:[\w.-]+/)+[\w.-]*|[\w.-]+)(?![\w.-])", text):
        if moved.name in match["path"] and (is_list or "/" in match["path"]):
            yield from components(match["path"], match.start("path"), ("", folder), moved, is_list)


def components(path: str, start: int, folders: Iterable[str], moved: MovedFolders, is_list: bool) -> Iterator[Span]:
    """Yield each part of a path that is the name, and moves where the path is followed from one of the folders."""
    for folder in folders:
        whole = posixpath.normpath(posixpath.join(folder, path))
        if not (is_list or whole in moved.files or whole in moved.folders):
            continue
        at = 0
        for part in path.split("/"):
            head = posixpath.normpath(posixpath.join(folder, path[: at + len(part)]))
            if part == moved.name and moved.moves.get(head, part) != part:
                yield Span(start + at, start + at + len(part))
            at += len(part) + 1
