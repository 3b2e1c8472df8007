"""Files that a package includes inside of `#if` alone, so that the preprocessor may never open them."""

from __future__ import annotations

from collections.abc import Iterable

from ...languages.cpp.file import CppFile
from ...package.cmake.cmake_project import CMake
from .header_inclusions import included_paths, paths_by_name
from .sources_by_use import sources_by_use


def only_under_conditions(cmake: CMake, sources: Iterable[CppFile]) -> frozenset[str]:
    """Return the files that others of the package include, and that no chain of includes without an `#if` leads to.

    The chains begin at the files that no other includes. Files that no target compiles are left out, where it is known.
    """
    files = {source.path: source for source in sources}
    known, _ = sources_by_use(cmake, files.values())
    if known.is_known and known.own:
        files = {path: file for path, file in files.items() if path in known.run | known.tests}
    by_name = paths_by_name(files)
    certain: dict[str, set[str]] = {path: set() for path in files}
    included = set[str]()
    for path, source in files.items():
        for each in source.includes:
            named = {other for other in included_paths(each.path, by_name) if other != path}
            included |= named
            certain[path] |= set() if each.is_conditional else named
    opened, waiting = set[str](), sorted(files.keys() - included)
    while waiting:
        path = waiting.pop()
        if path not in opened:
            opened.add(path)
            waiting += certain[path]
    return frozenset(included - opened)
