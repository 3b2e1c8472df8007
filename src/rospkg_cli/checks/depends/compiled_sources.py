"""Which C++ files of a package are compiled, or installed for others to include."""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterable, Iterator, Mapping

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cpp.file import CppFile
from ...package.cmake.cmake_project import CMake
from ...package.file_role import Role, role_of

HEADERS = (".hpp", ".h", ".hh", ".hxx", ".ipp", ".tpp", ".inl", ".cuh")


def compiled_sources(cmake: CMake, sources: Iterable[CppFile]) -> list[tuple[CppFile, Role]]:
    """Return the sources of targets, installed headers, and the files of the package that they include, with roles.

    Files that only tests use have the role `test`. All files are returned where the sources of a target are unknown.
    """
    files = {source.path: source for source in sources}
    known: dict[tuple[str, ...], list[tuple[CppFile, Role]]] = vars(cmake).setdefault("compiled_sources", {})
    if tuple(files) not in known:  # several rules ask for the same
        known[tuple(files)] = among(cmake, files)
    return known[tuple(files)]


def among(cmake: CMake, files: Mapping[str, CppFile]) -> list[tuple[CppFile, Role]]:
    named = {testing: named_sources(cmake, files, testing) for testing in (False, True)}
    if not are_sources_known(cmake):
        return [(source, "test" if cmake.only_tests else as_built(role_of(path))) for path, source in files.items()]
    public = {path for path in files if "include/" in path and not cmake.only_tests}
    run = with_included(files, named[False] | public)
    tests = with_included(files, named[True]) - run
    headers = {path for path in files if path.endswith(HEADERS) and as_built(role_of(path)) == "run"} - tests
    headers = headers if run or not tests else set()
    found: list[tuple[CppFile, Role]] = []
    for path, source in files.items():
        if path in run | headers:
            found.append((source, as_built(role_of(path))))
        elif path in tests:
            found.append((source, "test"))
    return found


def own_compiled(cmake: CMake, sources: Iterable[CppFile]) -> set[str] | None:
    """Return the files that the package's own build opens, without headers that only others do; None where unknown."""
    files = {source.path: source for source in sources}
    return with_included(files, named_sources(cmake, files, False)) if are_sources_known(cmake) else None


def compiled_on_demand(cmake: CMake, sources: Iterable[CppFile]) -> set[str]:
    """Return the files that are compiled under a condition alone, such as an option that is off by default."""
    files = {source.path: source for source in sources}
    every, certain = (with_included(files, named_sources(cmake, files, False, maybe=maybe)) for maybe in (True, False))
    return every - certain if are_sources_known(cmake) else set()


def as_built(role: Role) -> Role:
    return "run" if role == "launch" else role


def only_under_conditions(sources: Iterable[CppFile]) -> frozenset[str]:
    """Return the files that others of the package include, each of them between `#if` and `#endif`."""
    files = {source.path: source for source in sources}
    certain, guarded = set[str](), set[str]()
    by_name = paths_by_name(files)
    for source in files.values():
        for each in source.includes:
            (guarded if each.is_conditional else certain).update(included_paths(each.path, by_name))
    return frozenset(guarded - certain)


def paths_by_name(files: Iterable[str]) -> Mapping[str, list[str]]:
    found: dict[str, list[str]] = {}
    for path in files:
        found.setdefault(path.rpartition("/")[2], []).append(path)
    return found


def included_paths(header: str, by_name: Mapping[str, list[str]]) -> Iterator[str]:
    """Yield the files of the package that an include may mean."""
    if (known := by_name.get(header.rpartition("/")[2])) is not None:
        wanted = "/" + posixpath.normpath(header).lstrip("./")
        yield from (path for path in known if f"/{path}".endswith(wanted))


def with_included(files: Mapping[str, CppFile], first: Iterable[str]) -> set[str]:
    """Return some files, and those of the package that they include."""
    by_name = paths_by_name(files)
    found: set[str] = set()
    waiting = list(first)
    while waiting:
        path = waiting.pop()
        if path in found:
            continue
        found.add(path)
        for each in files[path].includes:
            waiting += included_paths(each.path, by_name)
    return found


def named_sources(cmake: CMake, files: Collection[str], testing: bool, *, maybe: bool = True) -> set[str]:
    """Return the files that any command names: one that is run for tests alone, or one that always is.

    Without `maybe`, commands under a condition that may not hold are left out.
    """
    bases: set[str] = set()
    for target in cmake.targets:
        base = path_in_package(target.folder.text, target.call.folder) if target.folder is not None else None
        if base is not None and target.call.testing is testing and (maybe or not target.call.maybe):
            bases.add(f"{base}/")
    found = {path for path in files if path.startswith(tuple(bases))} if bases else set()
    for call in cmake.calls:
        if call.testing is testing and (maybe or not call.maybe):
            paths = (path_in_package(word.text, call.folder) for word in call.words)
            found |= {path for path in paths if path is not None and path in files}
    return found


def are_sources_known(cmake: CMake) -> bool:
    """Return whether the sources of every target are known."""
    folders = (path_in_package(t.folder.text, t.call.folder) for t in cmake.targets if t.folder is not None)
    words = (word.is_known for target in cmake.targets for word in target.sources)
    return cmake.is_complete and all(words) and None not in folders
