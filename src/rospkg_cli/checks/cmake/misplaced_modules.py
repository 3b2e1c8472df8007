"""Extension modules that CMake builds for Python and installs where no interpreter looks."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.values import UNKNOWN, Word
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_install_table import CMakeTableBuilder
from ...package.cmake.cmake_package import CMakePackage
from ...package.file_role import role_of

MAKERS = ("pybind11_add_module", "nanobind_add_module", "python3_add_library", "python_add_library")
PLACES = ("lib", "bin", "share")
"""Folders from which nothing is imported, except by scripts in the same folder."""
ON_PATH = "PYTHONPATH"


@dataclass(frozen=True)
class MisplacedModule:
    word: Word
    destination: str
    is_imported: bool
    """Whether a Python file that the package installs imports it."""

    @property
    def sentence(self) -> str:
        start = f"`{self.word.text}` is a module of Python and is installed into `{self.destination}`"
        why = "" if self.is_imported else "; nothing that is installed here imports it"
        return f"{start}: importing it fails; use `${{PYTHON_INSTALL_DIR}}/${{PROJECT_NAME}}`{why}"


@dataclass(frozen=True)
class MisplacedModules:
    package: CMakePackage

    def all(self) -> Iterator[MisplacedModule]:
        """Yield each module whose places are all known and none of Python's.

        Scripts in the same folder may import it, and a hook may add the folder to PYTHONPATH.
        """
        found = list(self.installed()) if self.package.is_ament and not self.package.cmake.reads_unknown_files else []
        for word, place in found if found and not self.names_python_path else ():
            others = [each for other, each in found if other.text == word.text]
            if all(map(self.is_wrong, others)) and others[0] == place:
                yield MisplacedModule(word, place, self.is_imported(word.text))

    def installed(self) -> Iterator[tuple[Word, str]]:
        cmake = self.package.cmake
        artifacts = CMakeTableBuilder(cmake, self.package.facts.name).artifacts
        for rule in cmake.installs:
            for word in rule.items if rule.kind == "TARGETS" else ():
                target = cmake.target(word.text)
                if target is not None and target.call.name in MAKERS:
                    place = artifacts.destination(rule, target)
                    is_known = place is not None and not (rule.call.maybe or word.maybe)
                    yield word, place if is_known and place else UNKNOWN

    def is_wrong(self, place: str) -> bool:
        first = place.partition("/")[0]
        return first in PLACES and UNKNOWN not in place and "python" not in place and place not in self.of_scripts

    @cached_property
    def of_scripts(self) -> frozenset[str]:
        """The folders that hold files of Python, or may."""
        rules = (each for each in self.package.cmake.installs if each.kind != "TARGETS")
        return frozenset((each.destination or UNKNOWN).rstrip("/") for each in rules)

    @property
    def names_python_path(self) -> bool:
        """Whether a file of the package has the word PYTHONPATH."""
        files = self.package.cmake.package_files
        ends = (".txt", ".cmake", ".py", ".dsv", ".sh", ".in", ".xml", ".yaml", ".md")
        return any(ON_PATH in files.readable_text(path) for path in files.paths if path.endswith(ends))

    def is_imported(self, name: str) -> bool:
        """Return whether a file of Python that a rule installs, and no test, imports a module."""
        wanted = re.compile(rf"^[ \t]*(?:from|import)\b[^#\n]*\b{re.escape(name)}\b", re.MULTILINE)
        files = self.package.cmake.package_files
        rows = CMakeTableBuilder(self.package.cmake, self.package.facts.name).rows()
        paths = {row.source for row in rows if row.source.endswith(".py")}
        return any(wanted.search(files.readable_text(path)) for path in paths if role_of(path) != "test")
