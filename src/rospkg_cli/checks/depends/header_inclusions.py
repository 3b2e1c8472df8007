"""Which files of a package include which: the headers that a set of sources opens."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator, Mapping

from ...languages.cpp.file import CppFile, IncludeDirective

HEADERS = (".hpp", ".h", ".hh", ".hxx", ".ipp", ".tpp", ".inl", ".cuh")


class Inclusions:
    """Which files of a package include which."""

    def __init__(
        self, files: Mapping[str, CppFile], *, only_certain: bool = False, unconditional: bool = False
    ) -> None:
        self.files = files
        self.only_certain = only_certain
        """Whether an include that may name one of several files is ignored."""
        self.unconditional = unconditional
        """Whether an include inside of `#if` is ignored."""
        self.by_name = paths_by_name(files)
        self.known: dict[str, list[str]] = {}

    def included_by(self, path: str) -> list[str]:
        """Return the files of the package that one includes, wherever they lie."""
        if path not in self.known:
            counted = (each for each in self.files[path].includes if not (self.unconditional and each.is_conditional))
            self.known[path] = [other for each in counted for other in self.candidates(path, each)]
        return self.known[path]

    def candidates(self, path: str, each: IncludeDirective) -> list[str]:
        """Return the files that an include may name: the one in the same folder for `"…"`, else any with that path."""
        neighbour = posixpath.normpath(posixpath.join(posixpath.dirname(path), each.path))
        is_neighbour = neighbour in self.files and not each.is_angled
        found = [neighbour] if is_neighbour else list(included_paths(each.path, self.by_name))
        return [] if self.only_certain and len(found) > 1 else found

    def reached(self, first: Iterable[str]) -> set[str]:
        """Return some files, and those of the package that they include, and so on."""
        found: set[str] = set()
        waiting = list(first)
        while waiting:
            path = waiting.pop()
            if path not in found:
                found.add(path)
                waiting += self.included_by(path)
        return found


def paths_by_name(files: Iterable[str]) -> Mapping[str, list[str]]:
    """Return some paths by the name of the file: `node.hpp` → `["include/my_pkg/node.hpp"]`."""
    found: dict[str, list[str]] = {}
    for path in files:
        found.setdefault(path.rpartition("/")[2], []).append(path)
    return found


def included_paths(header: str, by_name: Mapping[str, list[str]]) -> Iterator[str]:
    """Yield the files of the package whose paths end with that of an include."""
    if (known := by_name.get(header.rpartition("/")[2])) is not None:
        wanted = "/" + posixpath.normpath(header).lstrip("./")
        yield from (path for path in known if f"/{path}".endswith(wanted))
