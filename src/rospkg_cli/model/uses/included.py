"""C++ includes against declarations and find_package."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import PurePosixPath

from ...ros.headers import LIBRARIES, SHARED
from ...ros.names import Known
from ...ros.stands_for import IN_SOURCES, brought
from ...source import Span
from ..cmake.project import CMake
from ..cpp.file import CppFile
from ..files import PackageFiles
from .declared import Declared
from .roles import Role, role_of
from .sought import SoughtAndDeclared


@dataclass(frozen=True, slots=True)
class IncludeUse:
    """A header of another package, and the file that includes it."""

    path: str
    span: Span
    header: str


@dataclass(frozen=True, slots=True)
class FromElsewhere:
    """What serves some includes: any of the names will do, the first is the one to recommend."""

    names: tuple[str, ...]
    cmake: str
    """The name for find_package."""
    role: Role
    uses: tuple[IncludeUse, ...]


@dataclass(frozen=True)
class Included:
    declared: Declared
    files: PackageFiles
    cmake: CMake
    sources: tuple[CppFile, ...]

    @cached_property
    def sought(self) -> SoughtAndDeclared:
        return SoughtAndDeclared(self.declared, self.cmake)

    def from_elsewhere(self) -> Iterator[FromElsewhere]:
        """Yield the packages and libraries whose headers are included, those of tests after those of what is built."""
        if not self.declared.judged:
            return
        found: dict[tuple[Role, str], list[IncludeUse]] = {}
        for source in self.sources:
            role = role_of(source.path)
            role = "run" if role == "launch" else role
            for each in source.includes if role != "aside" else ():
                first, slash, _ = each.path.partition("/")
                if slash and not each.conditional and not self.is_own(each.path):
                    found.setdefault((role, first), []).append(IncludeUse(source.path, each.span, each.path))
        for (role, first), uses in sorted(found.items(), key=lambda item: item[0][0] == "test"):
            if role == "test" and ("run", first) in found:
                continue
            names, cmake = self.serving(first)
            if names:
                yield FromElsewhere(names, cmake, role, tuple(uses))

    def serving(self, folder: str) -> tuple[tuple[str, ...], str]:
        """Return what serves the headers of a folder, and its name in CMake; nothing where nobody can tell."""
        if folder in LIBRARIES:
            return self.sought.serving(LIBRARIES[folder]), LIBRARIES[folder]
        facts = self.declared.workspace.named(folder)
        known = self.declared.workspace.what(folder) is Known.PACKAGE and folder not in SHARED
        if not known or (facts is not None and facts.metapackage):
            return (), folder
        return (folder,), folder

    def is_own(self, header: str) -> bool:
        return (
            header.partition("/")[0] == self.declared.facts.name
            or any(header == each or header.startswith(each + "/") for each in self.own_folders)
            or header in self.tails
        )

    @cached_property
    def own_folders(self) -> frozenset[str]:
        """The folders that stand in an `include/` or `src/` of the package: what is below them is its own."""
        found = set()
        for folder in self.files.folders:
            parts = PurePosixPath(folder).parts
            for at, part in enumerate(parts[:-1]):
                if part in ("include", "src", "test", "tests"):
                    found.add(parts[at + 1])
        return frozenset(found)

    @cached_property
    def tails(self) -> frozenset[str]:
        """The last two and three parts of every path: headers are found from wherever CMake looks."""
        found = set()
        for path in self.files.paths:
            parts = path.split("/")
            found |= {"/".join(parts[-n:]) for n in (2, 3, 4)}
        return frozenset(found)

    def undeclared(self) -> Iterator[FromElsewhere]:
        """Yield what is included and neither declared nor looked for by CMake."""
        there = brought(self.declared.names, IN_SOURCES)
        for each in self.from_elsewhere():
            declared = self.declared.has(each.names) or bool(self.sought.fitting(each.cmake, self.declared.names))
            if not declared and each.cmake not in self.found and not there.intersection(each.names):
                yield each

    @cached_property
    def found(self) -> frozenset[str]:
        """The names that CMake looks for."""
        return frozenset(found.name for found in self.cmake.packages)

    def is_brought(self, each: FromElsewhere) -> bool:
        """Return whether something that is declared brings these headers for certain."""
        return bool(self.declared.brought.intersection(each.names))
