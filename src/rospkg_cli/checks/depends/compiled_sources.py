"""Which C++ files of a package are compiled, or installed for others to include."""

from __future__ import annotations

from collections.abc import Iterable

from ...languages.cpp.file import CppFile
from ...package.cmake.cmake_project import CMake
from ...package.file_role import Role
from ..fault import Level
from .header_inclusions import HEADERS
from .installed_headers import may_be_installed
from .named_sources import is_named
from .sources_by_use import sources_by_use


def compiled_sources(cmake: CMake, sources: Iterable[CppFile]) -> list[tuple[CppFile, Role]]:
    """Return the sources of targets, installed headers, and the files of the package that they include, with roles.

    Files that only tests use have the role `test`. All files are returned where the sources of a target are unknown.
    Those that nothing compiles or installs come last.
    """
    known, files = sources_by_use(cmake, sources)
    found = [(source, role) for path, source in files.items() if (role := known.role(path)) is not None]
    return sorted(found, key=lambda each: known.is_left(cmake, each[0].path))


def own_compiled(cmake: CMake, sources: Iterable[CppFile]) -> set[str] | None:
    """Return the files that the build of the package opens, without headers for others alone; None where unknown."""
    known, _ = sources_by_use(cmake, sources)
    return known.own if known.is_known else None


def harm_in(cmake: CMake, sources: Iterable[CppFile], path: str) -> Level:
    """Return how bad it is that a file can't be compiled: an error where the build of the package certainly does so.

    It is a warning for what is compiled on demand, for tests, or by others alone. It is an info for what nothing
    compiles where other files are compiled, and for what only an option that is off, or a target outside of `all`,
    compiles. Where nothing is compiled, or it is unknown what is, it is an info for a header that is not installed and
    for a source that no CMake file names, else a warning.
    """
    known, _ = sources_by_use(cmake, sources)
    if path in known.own | known.tests:
        if known.is_known and path not in known.likely:
            return "info"
        return "error" if known.is_known and path in known.certain else "warning"
    if known.is_known and known.own:
        return "info"
    is_used = may_be_installed(cmake, path) if path.endswith(HEADERS) else is_named(cmake, path)
    return "warning" if is_used else "info"


def compiled_on_demand(cmake: CMake, sources: Iterable[CppFile]) -> set[str]:
    """Return the files that are compiled under a condition alone, such as an option that is off by default."""
    known, _ = sources_by_use(cmake, sources)
    always = known.certain | known.certain_tests
    return (known.own | known.tests) - always


def certainly_compiled(cmake: CMake, sources: Iterable[CppFile]) -> set[str]:
    """Return the files that every build of the package opens, or that every run of its tests does."""
    known, _ = sources_by_use(cmake, sources)
    return known.certain | known.certain_tests
