"""The include directories that a package exports, against the folders into which it installs headers (CMK106)."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import PREFIX, UNKNOWN
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.foreign_commands import foreign_commands
from ...package.cmake.installed_headers import INCLUDES, LIBRARIES, PLUGINS, TARGETS, PublicHeaders
from ...package.install_table import InstalledFile
from .exported_headers import AUTOMATIC

INTERFACE = regex(r"\$<INSTALL_INTERFACE:([^<>]*)>")
GENERATES = ("rosidl_generate_interfaces", "generate_parameter_library", "generate_export_header")
"""Commands that export include/ or include/<package> themselves, or install headers of their own there."""
PROPERTIES = ("set_target_properties", "set_property")
EXPORTING = (*INCLUDES, "target_include_directories", "install", *PROPERTIES)
OURS = "include"
"""The folder of the prefix that other packages may export as well."""


@dataclass(frozen=True, slots=True)
class UnexportedFolder:
    row: InstalledFile
    header: str
    """As users include it."""
    folder: str
    exported: tuple[str, ...]
    is_set_by_target: bool
    """Whether a target has another folder in `$<INSTALL_INTERFACE:…>`."""

    @property
    def is_shared(self) -> bool:
        """Whether it is the folder that other packages may export."""
        return self.folder == OURS


@dataclass(frozen=True)
class ExportedIncludeFolders:
    headers: PublicHeaders

    def unexported(self) -> UnexportedFolder | None:
        """Return the folder that all headers of include/ are installed to, where only others are exported."""
        cmake = self.headers.package.cmake
        is_known = cmake.is_complete and not cmake.reads_unknown_files and self.headers.table.knows("header")
        is_exported = self.headers.exports or (cmake.named(LIBRARIES) and not cmake.named(PLUGINS))
        if not is_known or not is_exported or cmake.named(*AUTOMATIC, *GENERATES) or cmake.functions:
            return None
        exported = [text for call in cmake.named(*EXPORTING) for text in exported_by(call)]
        rows = [row for row in self.headers.table.rows if row.source in self.headers.offered]
        name = self.headers.package.facts.name
        bases = {base_of(row, name) for row in rows}
        folder = bases.pop() if len(bases) == 1 else ""
        is_open = any(UNKNOWN in text or text[:1] == "/" for text in exported)
        if not folder or is_open or any(row.maybe for row in rows):
            return None
        if folder == OURS and not self.is_named_whole(rows):
            return None
        found = tuple(dict.fromkeys(posixpath.normpath(text) for text in exported))
        by_target = any(
            INTERFACE.search(text) for call in cmake.named("target_include_directories") for text in call.texts
        )
        header = rows[0].source.partition("/")[2]
        return None if folder in found else UnexportedFolder(rows[0], header, folder, found, by_target)

    def is_named_whole(self, rows: list[InstalledFile]) -> bool:
        """Return whether the package itself includes some of its headers, and each by its path below include/."""
        wholes = {row.source.partition("/")[2] for row in rows}
        files = {posixpath.basename(each) for each in wholes}
        own = [
            each.path
            for file in self.headers.sources
            if file.path not in self.headers.offered
            for each in file.includes
        ]
        near = [path for path in own if posixpath.basename(path) in files]
        return bool(near) and wholes.issuperset(near)


def base_of(row: InstalledFile, package: str) -> str:
    """Return the folder from which users include a header by its path below include/; "" where there is none.

    That path has to begin with the package's name: else users may put it before the path.
    """
    path = row.source.partition("/")[2]
    is_known = path.startswith(f"{package}/") and row.destination.endswith(f"/{path}")
    return row.destination.removesuffix(f"/{path}") if is_known else ""


def exported_by(call: EvaluatedCommand) -> Iterator[str]:
    """Yield the include directories below the prefix that a command exports; UNKNOWN where they can't be evaluated."""
    texts = call.texts
    if call.name in INCLUDES:
        yield from (text.removeprefix(f"{PREFIX}/") for text in texts)
    elif call.name == "install":
        at = texts.index("INCLUDES") + 2 if "INCLUDES" in texts else len(texts)
        yield from (text.removeprefix(f"{PREFIX}/") for text in texts[at:])
        yield from (UNKNOWN for text in texts if text == "FILE_SET")
    elif call.name not in PROPERTIES or any("INCLUDE" in text or UNKNOWN in text for text in property_names(call)):
        for text in texts:
            yield from (each.removeprefix(f"{PREFIX}/") for each in INTERFACE.findall(text))
            yield from (UNKNOWN for _ in text[:1] if UNKNOWN in text)


def exports_any_folder(cmake: CMake) -> bool:
    """Return whether a package may export any include directory, in whatever way."""
    names = (*INCLUDES, *TARGETS, *AUTOMATIC, *GENERATES)
    has_extras = any("CONFIG_EXTRAS" in text for call in cmake.calls for text in call.texts)
    return bool(cmake.named(*names)) or has_extras or next(foreign_commands(cmake), None) is not None


def property_names(call: EvaluatedCommand) -> tuple[str, ...]:
    """Return the names of the properties that a command sets; UNKNOWN where it has no keyword before them."""
    for keyword, step in (("PROPERTIES", 2), ("PROPERTY", 0)):
        if keyword in call.texts:
            after = call.texts[call.texts.index(keyword) + 1 :]
            return after[::step] if step else after[:1]
    return (UNKNOWN,)
