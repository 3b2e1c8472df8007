"""Which Python files of a package are installed or run as tests."""

from __future__ import annotations

import re
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...unreadable import UnreadableError
from ..install_table import InstallTable

PROGRAMS = regex(r"\binstall\s*\(\s*PROGRAMS\b([^)]*)\)", re.IGNORECASE)
PYTHON_PACKAGE = regex(r"\bament_python_install_package\s*\(", re.IGNORECASE)


class InstalledPython:
    """The Python files that the install table has; where it is unknown, those that the files suggest."""

    def __init__(self, files: PackageFiles, table: InstallTable | None) -> None:
        self.files = files
        self.is_known = table is not None and table.knows("module") and table.knows("executable")
        rows = table.rows if table else ()
        self.sources = frozenset(row.source for row in rows if row.what in ("module", "executable"))
        self.shared = frozenset(row.source for row in rows if row.what == "share")

    def has(self, path: str) -> bool:
        if path in self.sources:
            return True
        is_program = path.rpartition("/")[2] in self.programs
        if self.is_known:
            return is_program and path in self.shared and not self.is_run_by_cmake(path)
        if is_program:
            return True
        in_a_package = self.files.exists(f"{path.rpartition('/')[0]}/__init__.py")
        return in_a_package and (self.packages or not self.cmake)

    def is_test(self, path: str) -> bool:
        """Return whether a file among the tests is run with them: CMake names it or its folder, or pytest finds it."""
        folder, _, name = path.rpartition("/")
        if self.cmake and path.endswith(".in"):
            return name in self.cmake or "}.py.in" in self.cmake
        if self.cmake:
            return name in self.cmake or re.search(rf"\b{re.escape(folder)}/?[\s)\"]", self.cmake) is not None
        return "test" in name

    @cached_property
    def cmake(self) -> str:
        """The text of every CMakeLists.txt of the package, where setup.py does not build it."""
        if not self.files.exists("CMakeLists.txt"):
            return ""
        found = []
        for path in self.files.paths:
            if path == "CMakeLists.txt" or path.endswith("/CMakeLists.txt"):
                try:
                    found.append(self.files.source(path).text)
                except UnreadableError:
                    continue
        return "\n".join(found)

    @cached_property
    def programs(self) -> frozenset[str]:
        """The names of the scripts that install(PROGRAMS) names."""
        words = " ".join(match.group(1) for match in PROGRAMS.finditer(self.cmake)).split()
        return frozenset(word.rpartition("/")[2] for word in words)

    def is_run_by_cmake(self, path: str) -> bool:
        """Return whether a macro for other packages names a script: it runs in their builds and tests."""
        name, files = path.rpartition("/")[2], self.files
        macros = (each for each in files.paths if each.endswith((".cmake", ".cmake.in")))
        return any(name in files.readable_text(each) for each in macros)

    @cached_property
    def packages(self) -> bool:
        """Whether Python packages are installed at all."""
        return bool(PYTHON_PACKAGE.search(self.cmake))
