"""Installed headers that include one of the package that is not installed: users can't compile them (CMK106)."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from functools import cached_property

from ...languages.cpp.file import CppFile, IncludeDirective
from ...light_dataclasses import dataclass
from ...package.cmake.foreign_commands import foreign_commands
from ...package.cmake.installed_headers import HEADERS
from .exported_headers import AUTOMATIC, ExportedHeaders

WINDOW, DRAWN, GENERATED = "ui_", ".ui", ".h"
"""How Qt calls what it makes of the drawing of a window."""


@dataclass(frozen=True, slots=True)
class PrivateInclude:
    file: CppFile
    include: IncludeDirective
    source: str
    """The file of the package that is included, or that it is made of."""


@dataclass(frozen=True)
class PrivateIncludes:
    exported: ExportedHeaders

    def all(self) -> Iterator[PrivateInclude]:
        """Yield each header that lacks, at the first place; nothing where the package exports no headers."""
        headers = self.exported.headers
        cmake = headers.package.cmake
        is_known = cmake.is_complete and not cmake.reads_unknown_files and headers.table.knows("header")
        is_plain = not cmake.named(*AUTOMATIC) and next(foreign_commands(cmake), None) is None
        if not (is_known and is_plain and headers.package.is_ament and headers.exports):
            return
        seen: set[str] = set()
        for file in headers.sources:
            if file.path in headers.installed and "__has_include" not in file.source.text:
                for include in file.includes:
                    source = self.lost(file, include) if not include.is_conditional else ""
                    if source and source not in seen:
                        seen.add(source)
                        yield PrivateInclude(file, include, source)

    def lost(self, file: CppFile, include: IncludeDirective) -> str:
        """Return the file of the package that an include means and that nothing installs; "" where there is none."""
        name = posixpath.basename(include.path)
        neighbour = posixpath.normpath(posixpath.join(posixpath.dirname(file.path), include.path))
        own = self.exported.headers.package.facts.name
        others = (each for each in self.exported.workspace.having("header_files", include.path) if each.name != own)
        is_own = include.path.startswith(f"{own}/") or not include.is_angled
        if not is_own or name in self.named or next(others, None) is not None:
            return ""
        paths = [path for path in self.by_name.get(name, ()) if f"/{path}".endswith(f"/{include.path}")]
        found = [neighbour] if neighbour in self.by_name.get(name, ()) else paths
        if not found and name.startswith(WINDOW) and name.endswith(GENERATED):
            found = self.by_name.get(name.removeprefix(WINDOW).removesuffix(GENERATED) + DRAWN, [])
        return "" if not found or self.sources.intersection(found) else found[0]

    @cached_property
    def by_name(self) -> dict[str, list[str]]:
        """The headers of the package, and the drawings of its windows, by the last parts of their paths."""
        found: dict[str, list[str]] = {}
        for path in self.exported.headers.package.cmake.package_files.paths:
            if path.endswith((*HEADERS, DRAWN)):
                found.setdefault(posixpath.basename(path), []).append(path)
        return found

    @cached_property
    def sources(self) -> frozenset[str]:
        return frozenset(row.source for row in self.exported.headers.table.rows)

    @cached_property
    def named(self) -> frozenset[str]:
        """The last parts of all that a command writes or installs: a header may come from another place."""
        rows = (posixpath.basename(row.destination) for row in self.exported.headers.table.rows)
        calls = self.exported.headers.package.cmake.named("configure_file", "file", "add_custom_command", "install")
        return frozenset((*rows, *(posixpath.basename(text) for call in calls for text in call.texts)))
