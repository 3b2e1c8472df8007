"""Which C++ files of a package are compiled, or installed for others to include."""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterable

from ..cmake.call import located
from ..cmake.project import CMake
from ..cpp.file import CppFile

HEADERS = (".hpp", ".h", ".hh", ".hxx", ".ipp", ".tpp", ".inl", ".cuh")


def compiled(cmake: CMake, sources: Iterable[CppFile]) -> list[CppFile]:
    """Return the files that a target is made of, what they include of the package, and the headers of `include/`.

    All of them where the sources of a target can't be told.
    """
    files = {source.path: source for source in sources}
    named, told = named_sources(cmake, files)
    if not told:
        return list(files.values())
    by_name: dict[str, list[str]] = {}
    for path in files:
        by_name.setdefault(path.rpartition("/")[2], []).append(path)
    reached: set[str] = set()
    waiting = [path for path in files if path in named or "include/" in path]
    while waiting:
        path = waiting.pop()
        if path in reached:
            continue
        reached.add(path)
        for each in files[path].includes:
            for other in by_name.get(each.path.rpartition("/")[2], ()):
                if f"/{other}".endswith(f"/{posixpath.normpath(each.path).lstrip('./')}"):
                    waiting.append(other)
    return [files[path] for path in files if path in reached]


def named_sources(cmake: CMake, files: Collection[str]) -> tuple[set[str], bool]:
    """Return the files that any command names, and whether it can be told what targets are made of."""
    found: set[str] = set()
    told = cmake.complete
    for target in cmake.targets:
        told &= all(word.known for word in target.sources)
        if target.folder is not None:
            base = located(target.folder.text, target.call.folder)
            told &= base is not None
            found |= {path for path in files if base is not None and path.startswith(f"{base}/")}
    for call in cmake.calls:
        paths = (located(word.text, call.folder) for word in call.words)
        found |= {path for path in paths if path is not None and path in files}
    return found, told
