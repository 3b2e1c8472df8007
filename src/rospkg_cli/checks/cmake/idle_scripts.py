"""Python programs in a folder of which nothing is installed, in a package that installs other files (CMK112)."""

from __future__ import annotations

import posixpath
import re

from ...light_dataclasses import dataclass
from ...package.cmake.foreign_commands import foreign_commands
from .installed_scripts import InstalledScripts
from .left_out_nodes import MAIN, is_node, is_python
from .script_files import FOR_ROS1
from .script_starts import is_readme

FOLDERS = ("scripts", "script", "nodes")
AUTO = ("ament_auto_add_executable", "ament_auto_add_library")
"""Commands whose targets `ament_auto_package()` installs."""
SHORTEST = 8
"""Letters that a name needs so that the same word in a README stands for the program."""


@dataclass(frozen=True)
class IdleScripts:
    scripts: InstalledScripts

    def first(self) -> tuple[str, ...]:
        """Return the programs of the first such folder of which one is a node, or named in a README."""
        cmake = self.scripts.package.cmake
        rules = (rule for rule in cmake.installs if rule.kind != "TARGETS")
        is_open = any(rule.kind == "CODE" or rule.destination is None or rule.call.maybe for rule in rules)
        is_known = cmake.is_complete and cmake.ends_a_package and not cmake.reads_unknown_files and not is_open
        is_installed = bool(cmake.installs) or any(call.name.startswith(AUTO) for call in cmake.calls)
        if not is_known or not is_installed or next(foreign_commands(cmake), None) is not None:
            return ()
        for folder in FOLDERS:
            found = () if self.is_named(folder) else self.programs(folder)
            if any(is_node(path, cmake.package_files) or self.is_in_readme(path) for path in found):
                return found
        return ()

    def is_named(self, folder: str) -> bool:
        """Return whether a CMake file has the word, in a comment too."""
        word = re.compile(rf"\b{folder}\b")
        return any(word.search(file.source.text) for file in self.scripts.package.cmake.files)

    def programs(self, folder: str) -> tuple[str, ...]:
        """Return the executable programs in Python that lie in a folder itself."""
        files = self.scripts.package.cmake.package_files
        paths = (path for path in files.below(folder) if posixpath.dirname(path) == folder)
        return tuple(path for path in paths if self.is_program(path) and not files.absent.is_ignored(path))

    def is_program(self, path: str) -> bool:
        text = self.scripts.package.cmake.package_files.readable_text(path)
        is_main = MAIN.search(text) is not None and FOR_ROS1.search(text) is None
        is_program = is_python(path, self.scripts.package.cmake.package_files) and is_main
        return is_program and self.scripts.script_files.has_shebang(path) and self.scripts.script_files.has_bit(path)

    def is_in_readme(self, path: str) -> bool:
        """Return whether a README has the name of a program, with its suffix or without, and not its folder."""
        files, name = self.scripts.package.cmake.package_files, posixpath.basename(path)
        stem = name.removesuffix(".py")
        word = re.compile(rf"(?<![\w/.-]){re.escape(stem)}(?:\.py)?(?![\w/-])")
        texts = (files.readable_text(each) for each in files.paths if is_readme(each))
        return len(stem) >= SHORTEST and any(word.search(text) for text in texts)
