"""For what the build uses each C++ file of a package: for what it installs, for tests, or for nothing."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from ...languages.cpp.file import CppFile
from ...package.cmake.cmake_project import CMake
from ...package.file_role import Role, role_of
from ..cmake.switched_off import SwitchedOff
from .header_inclusions import HEADERS, Inclusions
from .installed_headers import may_be_installed
from .named_sources import are_sources_known, is_named, named_sources
from .unadded_folders import files_nothing_adds


class SourcesByUse:
    """Which files of a package its build compiles; `sources_by_use` keeps it with the CMake of the package."""

    def __init__(self, cmake: CMake, files: Mapping[str, CppFile]) -> None:
        self.paths = tuple(files)
        self.is_known = are_sources_known(cmake)
        including = Inclusions(files)
        named = {testing: named_sources(cmake, files, testing) for testing in (False, True)}
        self.own = including.reached(named[False])
        off = SwitchedOff(cmake)
        on = (named_sources(cmake, files, testing, off=off) for testing in (False, True))
        self.likely = including.reached(set().union(*on))
        self.certain = including.reached(named_sources(cmake, files, False, maybe=False))
        self.including = including
        self.headers = {path for path in files if path.endswith(HEADERS) and not cmake.only_tests}
        public = {path for path in self.headers if "include/" in path}
        self.run = including.reached(named[False] | public)
        self.tests = including.reached(named[True]) - self.run
        asked = not any(call.texts[::2][:2] == ("BUILD_TESTING", "OFF") for call in cmake.named("option"))
        self.certain_tests = including.reached(named_sources(cmake, files, True, maybe=False)) if asked else set[str]()
        self.only_tests = cmake.only_tests
        self._unadded: frozenset[str] | None = None
        self._installed_headers: set[str] | None = None

    def unadded(self, cmake: CMake) -> frozenset[str]:
        """Return the files below a CMakeLists.txt that nothing adds, where it is not known which files are compiled."""
        if self._unadded is None:
            is_open = self.is_known or cmake.includes_unknown_files
            found = frozenset[str]() if is_open else files_nothing_adds(cmake.package_files, cmake, self.paths)
            self._unadded = found - self.run - self.tests
        return self._unadded

    def is_left(self, cmake: CMake, path: str) -> bool:
        """Return whether no target compiles a file or one that includes it, and it is not installed either.

        Where a package compiles nothing, its build may be unfinished: only a file that CMake names counts, be it in a
        comment.
        """
        if not self.is_known:
            return path in self.unadded(cmake)
        if not (self.own or self.tests or is_named(cmake, path)):
            return False
        if path in self.headers - self.own - self.tests:
            return path not in self.installed_headers(cmake)
        if path in self.run | self.tests or path not in self.paths:
            return False
        return self.role(path) is None or not may_be_installed(cmake, path)

    def installed_headers(self, cmake: CMake) -> set[str]:
        """Return the headers that may be installed, and the files that they include."""
        if self._installed_headers is None:
            self._installed_headers = self.including.reached(
                each for each in self.headers if may_be_installed(cmake, each)
            )
        return self._installed_headers

    def role(self, path: str) -> Role | None:
        """Return the role of a file that is compiled, or installed for others; None for any other."""
        if not self.is_known:
            return "test" if self.only_tests else as_built(role_of(path))
        if path in self.tests:
            return "test"
        built = as_built(role_of(path))
        is_header = path.endswith(HEADERS) and built == "run" and bool(self.run or not self.tests)
        return built if path in self.run or is_header else None


def sources_by_use(cmake: CMake, sources: Iterable[CppFile]) -> tuple[SourcesByUse, Mapping[str, CppFile]]:
    """Return the uses of some sources, computed once for all rules, and the sources by path."""
    files = {source.path: source for source in sources}
    known: SourcesByUse | None = vars(cmake).get("sources_by_use")
    if known is None or known.paths != tuple(files):
        known = vars(cmake)["sources_by_use"] = SourcesByUse(cmake, files)
    return known, files


def as_built(role: Role) -> Role:
    return "run" if role == "launch" else role
