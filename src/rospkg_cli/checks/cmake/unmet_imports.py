"""Why nothing is known to reach an import that fails in an installed Python file."""

from __future__ import annotations

import posixpath
import re

from ...files import PackageFiles
from ...languages.python.file import PythonFile
from ...languages.python.imports import Import
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.install_table import InstalledFile
from ...package.launch.live_text import live_text
from ..python.ros1_import import ros1_import
from ..reached_definitions import ReachedDefinitions
from ..repository.pages_and_scripts import pages_and_scripts

NAMING = (".py", ".xml", ".launch", ".yaml", ".yml")


@dataclass(frozen=True)
class UnmetImports:
    files: PackageFiles
    definitions: ReachedDefinitions | None

    def why(self, file: PythonFile, each: Import, row: InstalledFile) -> str:
        """Return why nothing reaches an import, as the end of a sentence; "" where something may."""
        first = ros1_import(file.imports)
        if first is not None and (each.is_local or first.span.start < each.span.start):
            return f"; the file is for ROS 1, and ends at `{first.module}` before"
        if each.is_local and self.definitions is not None and not self.definitions.leads_to(file, each.span):
            return "; nothing here leads to this function"
        is_data = row.what == "share" and role_of(row.source) != "launch"
        return "; nothing here starts or names that file" if is_data and not self.is_named(row.source) else ""

    def is_named(self, path: str) -> bool:
        """Return whether another file of the package, a page or a script has the name of a file, or imports it."""
        name = posixpath.basename(path)
        stem = re.escape(name.removesuffix(".py"))
        word = re.compile(rf"(?<![\w-])(?:{re.escape(name)}|(?:import|from)(?![\w-])[^\n]*(?<!\w){stem})(?!\w)")
        others = (each for each in self.files.paths if each != path and each.endswith(NAMING))
        texts = (live_text(self.files, each) for each in others if role_of(each) != "test")
        return any(map(word.search, (*pages_and_scripts(self.files), *texts)))
