"""Libraries that are installed along with their headers, and that no other package can link (CMK119)."""

from __future__ import annotations

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.targets import Target
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass
from ...package.cmake.artifacts import PYTHON_MODULES, Artifacts
from ...package.cmake.foreign_commands import foreign_commands
from ...package.cmake.installed_headers import LIBRARIES, TARGETS, PublicHeaders
from .exported_headers import AUTOMATIC, ExportedHeaders
from .exported_include_folders import exports_any_folder
from .unexported_targets import LOADED, UnexportedSet, UnexportedTargets

EXPORTING = (LIBRARIES, *TARGETS, *AUTOMATIC, "ament_export_link_flags", "export")
"""Commands that hand a library on, or may do so."""
OWN_WAY = (".cmake", ".cmake.in", ".pc", ".pc.in")
"""Endings of files in which a package may itself tell others of its libraries."""


@dataclass(frozen=True)
class UnexportedLibraries:
    sets: UnexportedTargets
    exported: ExportedHeaders

    @property
    def headers(self) -> PublicHeaders:
        return self.exported.headers

    def first(self) -> Word | None:
        """Return the first library whose headers others can include, where the package exports no library."""
        cmake = self.headers.package.cmake
        is_clear = cmake.is_complete and not cmake.reads_unknown_files and cmake.ends_a_package
        if not self.headers.package.is_ament or not is_clear or self.has_own_way:
            return None
        for rule in cmake.installs if self.headers.table.knows("header") else ():
            for word in rule.items if rule.kind == "TARGETS" and not (rule.call.maybe or rule.call.testing) else ():
                target = cmake.target(word.text)
                is_there = target is not None and Artifacts(cmake).destination(rule, target) == "lib"
                if is_there and target is not None and self.sets.is_library(word) and self.has_headers(target):
                    return word
        return None

    @property
    def has_own_way(self) -> bool:
        """Whether any command may export a library, or a file of the package does so in its own way."""
        cmake = self.headers.package.cmake
        is_named = any(call.name in EXPORTING for call in (*cmake.calls, *cmake.unreachable))
        is_named = is_named or any(rule.kind in ("EXPORT", "CODE") or rule.export for rule in cmake.installs)
        read = {file.path for file in cmake.files}
        others = (path for path in cmake.package_files.paths if path.endswith(OWN_WAY) and path not in read)
        has_extras = any("CONFIG_EXTRAS" in text for call in cmake.calls for text in call.texts)
        return is_named or has_extras or any(others) or next(foreign_commands(cmake), None) is not None

    def has_headers(self, target: Target) -> bool:
        """Return whether a source of a library that is linked includes a header that is installed."""
        if not target.is_built or "MODULE" in target.options or target.call.name in PYTHON_MODULES:
            return False
        offered = self.headers.installed.intersection(self.headers.offered)
        private = {file.path for file in self.headers.sources} - offered
        ends = {end for path in offered for end in ends_of(path)}
        ends -= {end for path in private for end in ends_of(f"/{path}")}
        paths = {path_in_package(word.text, target.call.folder) for word in target.sources}
        files = [file for file in self.headers.sources if file.path in paths]
        if any(LOADED.search(file.source.text) for file in files):
            return False
        return any(each.path in ends for file in files for each in file.includes)

    def is_missed(self, found: UnexportedSet) -> bool:
        """Return whether a package of the workspace includes a header of this one, for which it needs the set."""
        has_all = not found.is_built and exports_any_folder(self.headers.package.cmake)
        return self.exported.are_needed and not (found.is_exported_otherwise or has_all)

    @property
    def is_needed(self) -> bool:
        """Whether a package of the workspace includes a header of this one, which brings it nothing else."""
        return self.exported.are_needed and not self.headers.package.cmake.interface_targets


def ends_of(path: str) -> list[str]:
    """Return how a header of include/ may be included: below it, or below a folder of it that is searched as well."""
    parts = path.split("/")
    return ["/".join(parts[n:]) for n in range(1, len(parts))]
