"""The folder of another package that is intended by a misspelt one in an `#include`."""

from __future__ import annotations

from functools import cached_property

from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.made_headers import HEADERS
from ...package.workspace import Workspace
from ...ros.headers import LIBRARIES, SHARED
from ...ros.interfaces import KINDS, header_name
from ...ros.names import NameKind
from ...suggest import near_names
from ..cmake.name_slips import digits
from ..interfaces.known_interfaces import KnownInterfaces
from .known_headers import KnownHeaders

FOLDER = regex(r"[a-z][a-z0-9_]{4,}")
SHORT = 8
"""Letters of a folder's name from which two may be wrong."""


@dataclass(frozen=True)
class NearHeaderFolders:
    package: CMakePackage
    sources: tuple[CppFile, ...]
    workspace: Workspace
    known: KnownHeaders

    def in_right_folder(self, header: str) -> str | None:
        """Return the header in the folder of the one package that is near and has it; None where there is none."""
        folder, _, rest = header.partition("/")
        if not FOLDER.fullmatch(folder) or folder in self.folders:
            return None
        if self.workspace.kind_of(folder) in (NameKind.PACKAGE, NameKind.KEY):
            return None
        alike = (each for each in self.packages if digits(each) == digits(folder))
        near = near_names(folder, alike, 1 if len(folder) < SHORT else 2)
        found = [f"{each}/{rest}" for each in near if self.has(each, rest)] or self.with_other_digits(folder, rest)
        return found[0] if len(found) == 1 and not self.is_of_others(folder) else None

    def with_other_digits(self, folder: str, rest: str) -> list[str]:
        """Return the headers, with any ending, of packages of the workspace whose name has a digit more or less."""
        stem, name = rest.rpartition(".")[0], folder.rstrip("0123456789_")
        near = [facts for facts in self.workspace.packages if facts.name.rstrip("0123456789_") == name]
        wanted = {f"{facts.name}/{stem}{ending}" for facts in near for ending in HEADERS}
        return sorted({each for facts in near for each in facts.header_files if each in wanted}) if stem else []

    def is_of_others(self, folder: str) -> bool:
        """Return whether another package of the workspace has headers in a folder."""
        headers = (each for facts in self.workspace.packages for each in facts.header_files)
        return any(each.startswith(f"{folder}/") for each in headers)

    def has(self, package: str, rest: str) -> bool:
        """Return whether a package certainly has a header in the folder of its name."""
        kind, _, name = rest.partition("/")
        if kind in KINDS and (known := self.interfaces.of(package)) is not None:
            return name.partition(".")[0] in map(header_name, known.get(kind, ()))
        return self.known.is_there(f"{package}/{rest}") or package in self.used

    @cached_property
    def packages(self) -> frozenset[str]:
        """The packages whose headers the package may include."""
        return frozenset({*self.workspace.names, *self.declared, self.package.facts.name})

    @cached_property
    def declared(self) -> frozenset[str]:
        return frozenset(each.name for each in self.package.manifest.dependencies)

    @cached_property
    def used(self) -> frozenset[str]:
        """The folders from which more than one header is included: those of packages that are declared and not here."""
        outside = self.declared.difference(self.workspace.names)
        named = [each.path.partition("/")[0] for source in self.sources for each in source.includes]
        return frozenset(name for name in outside if named.count(name) > 1)

    @cached_property
    def folders(self) -> frozenset[str]:
        """The folders of the package and of libraries, and the packages that are here or declared."""
        own = (part for path in self.package.cmake.package_files.paths for part in path.split("/")[:-1])
        return frozenset({*own, *LIBRARIES, *SHARED, *self.packages})

    @cached_property
    def interfaces(self) -> KnownInterfaces:
        return KnownInterfaces(self.package.facts, self.workspace)
