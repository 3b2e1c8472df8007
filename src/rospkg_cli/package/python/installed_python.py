"""Which Python files of a package are installed or run as tests."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...unreadable import UnreadableError
from ..install_table import InstalledFile, InstallTable

PROGRAMS_FOLDER = "lib/"
PROGRAMS = regex(r"\binstall\s*\(\s*PROGRAMS\b([^)]*)\)", re.IGNORECASE)
PYTHON_PACKAGE = regex(r"\bament_python_install_package\s*\(([^)]*)", re.IGNORECASE)
IMPORT = regex(r"^[ \t]*(?:from|import)\b[^#\n]*", re.MULTILINE)
HERE = "${CMAKE_CURRENT_SOURCE_DIR}/"


class InstalledPython:
    """The Python files that the install table has; where it is unknown, those that the files suggest."""

    def __init__(self, files: PackageFiles, table: InstallTable | None, started: Iterable[str] = ()) -> None:
        self.files = files
        self.started = frozenset(f"{module.replace('.', '/')}.py" for module in started)
        """The modules of entry points: a linked build finds them in folders without `__init__.py`, too."""
        self.is_known = table is not None and table.knows("module") and table.knows("executable")
        rows = table.rows if table else ()
        self.sources = frozenset(row.source for row in rows if row.what in ("module", "executable") or is_beside(row))
        self.shared = frozenset(row.source for row in rows if row.what == "share")

    def has(self, path: str) -> bool:
        if path in self.sources or path in self.started:
            return True
        is_program = path.rpartition("/")[2] in self.programs
        if self.is_known:
            return is_program and path in self.shared and not self.is_run_by_cmake(path)
        if is_program:
            return True
        if not self.files.exists(f"{path.rpartition('/')[0]}/__init__.py"):
            return False
        if not self.cmake or self.folders is None:
            return bool(not self.cmake or self.packages)
        return path.startswith(self.folders) or self.is_imported(path)

    def is_imported(self, path: str) -> bool:
        """Return whether an import of any file names a module, which Python may find in the same folder."""
        folder, _, name = path.rpartition("/")
        module = folder.rpartition("/")[2] if name == "__init__.py" else name.removesuffix(".py")
        return module in self.imported

    @cached_property
    def imported(self) -> frozenset[str]:
        """The words of all imports of the package."""
        texts = (self.files.readable_text(path) for path in self.files.paths if path.endswith(".py"))
        return frozenset(word for text in texts for line in IMPORT.findall(text) for word in re.findall(r"\w+", line))

    @cached_property
    def folders(self) -> tuple[str, ...] | None:
        """The folders of the Python packages that CMake installs; None where that is not known."""
        found = []
        for match in PYTHON_PACKAGE.finditer(self.cmake):
            words = match.group(1).split()
            given = words.index("PACKAGE_DIR") + 1 if "PACKAGE_DIR" in words else 0
            found += [word.strip('"').removeprefix(HERE).strip("/") + "/" for word in words[given : given + 1]]
        others = [each for each in self.files.paths if each.endswith((".cmake", "/CMakeLists.txt"))]
        is_hidden = any(self.files.holds(each, b"python_install") for each in others)
        return None if is_hidden or not found or any("$" in each for each in found) else tuple(found)

    @cached_property
    def cmake_lists(self) -> tuple[str, ...]:
        return tuple(path for path in self.files.paths if path.rpartition("/")[2] == "CMakeLists.txt")

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
        for path in self.cmake_lists:
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


def is_beside(row: InstalledFile) -> bool:
    """Return whether a file is installed below the folder of programs, where Python finds it as their module."""
    return row.source.endswith(".py") and row.destination.startswith(PROGRAMS_FOLDER)
