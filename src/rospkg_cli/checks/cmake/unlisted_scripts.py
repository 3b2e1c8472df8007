"""Scripts in no install rule, next to others of the same folder that are installed (CMK112)."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...languages.cmake.evaluated_command import path_in_package
from ...light_dataclasses import dataclass
from ...package.cmake.copied_files import CopiedFile
from .installed_scripts import InstalledScripts
from .left_out_nodes import is_last, is_left_out

SHELL = (".sh", ".bash")
"""Scripts that mostly help developers."""
ASIDE = frozenset({"test", "tests"})


@dataclass(frozen=True)
class UnlistedScripts:
    scripts: InstalledScripts

    def all(self) -> Iterator[tuple[str, CopiedFile]]:
        """Yield the scripts that no rule installs, each with an installed script of its folder."""
        cmake = self.scripts.package.cmake
        if any(rule.kind == "CODE" or rule.destination is None for rule in cmake.installs if rule.kind != "TARGETS"):
            return
        programs = {copy.source: copy for copy in self.scripts.copies if copy.rule.kind == "PROGRAMS"}
        named = {path for call in cmake.calls for text in call.texts if (path := path_in_package(text, call.folder))}
        for folder in sorted({posixpath.dirname(path) for path in programs}):
            installed = next(copy for path, copy in programs.items() if posixpath.dirname(path) == folder)
            for path in cmake.package_files.paths:
                fits = posixpath.dirname(path) == folder and path not in named and self.is_script(path)
                if not fits or (path.endswith(SHELL) and not self.scripts.starts.is_wanted(path)):
                    continue
                if not self.scripts.is_installed(path) and not ASIDE.intersection(path.split("/")):
                    yield path, installed

    def is_script(self, path: str) -> bool:
        """Return whether a file is a program that a user may want to run."""
        scripts = self.scripts.script_files
        is_private = posixpath.basename(path).startswith((".", "_", "test_")) or scripts.is_for_ros1(path)
        if is_private or not scripts.is_runnable(path) or not scripts.has_shebang(path):
            return False
        if scripts.has_bit(path) or any(posixpath.basename(path) in text for text in self.scripts.texts):
            return True
        files, is_installed = self.scripts.package.cmake.package_files, self.scripts.is_installed
        return is_left_out(path, files, is_installed) or is_last(path, files, is_installed)
