"""Rule input: the files of a package that CMake copies, and the scripts in lib/<package> among them."""

from __future__ import annotations

import posixpath
from functools import cached_property

from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.copied_files import CopiedFile, copied_files
from ...package.workspace import Workspace
from .script_files import ScriptFiles
from .script_starts import ScriptStarts


@dataclass(frozen=True)
class InstalledScripts:
    package: CMakePackage
    workspace: Workspace

    @cached_property
    def copies(self) -> tuple[CopiedFile, ...]:
        """The files of the package that are copied to lib/<package> itself."""
        home = f"lib/{self.package.facts.name}"
        return tuple(copy for copy in self.everywhere if posixpath.dirname(copy.destination) == home)

    @cached_property
    def everywhere(self) -> tuple[CopiedFile, ...]:
        """All files of the package that are certainly copied."""
        rules = (rule for rule in self.package.cmake.installs if not rule.call.maybe and not rule.call.testing)
        copies = (copy for rule in rules for copy in copied_files(rule, self.package.cmake.package_files))
        return tuple(copy for copy in copies if not copy.item.maybe)

    @property
    def uses_programs(self) -> bool:
        """Whether some scripts are installed as they should be."""
        return any(copy.rule.kind == "PROGRAMS" for copy in self.copies)

    def is_installed(self, path: str) -> bool:
        """Return whether any rule copies a file, anywhere."""
        files = self.package.cmake.package_files
        return any(path == copy.source for rule in self.package.cmake.installs for copy in copied_files(rule, files))

    @cached_property
    def texts(self) -> tuple[str, ...]:
        """The installed scripts' texts."""
        return tuple(self.package.cmake.package_files.readable_text(copy.source) for copy in self.copies)

    @cached_property
    def script_files(self) -> ScriptFiles:
        return ScriptFiles(self.package.cmake.package_files)

    @cached_property
    def starts(self) -> ScriptStarts:
        return ScriptStarts(self.package.facts.name, self.package.cmake.package_files, self.workspace, self.texts)
