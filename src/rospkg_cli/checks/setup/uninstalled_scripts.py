"""Rule input: programs of an ament_python package that nothing installs (SET107)."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from functools import cached_property

from ...languages.python.file import PythonFile
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.install_table import InstallTable
from ...source import Span
from .python_package import PythonPackage
from .unregistered_nodes import UnregisteredNodes, starts_itself

FOLDERS = ("", "bin", "nodes", "scripts", "src")
"""Folders for programs next to the Python package; programs in other folders are for developers."""


@dataclass(frozen=True)
class UninstalledScripts:
    package: PythonPackage
    nodes: UnregisteredNodes
    table: InstallTable

    @cached_property
    def installed(self) -> frozenset[str]:
        return frozenset(row.source for row in self.table.rows)

    def found(self) -> Iterator[tuple[str, Span]]:
        """Yield the nodes in folders of scripts that nothing installs and nothing names, and where their `main` is."""
        setup = self.package.setup
        known = setup.knows("scripts") and setup.knows("data_files") and setup.knows("packages")
        if not known or setup.may_write_files or self.package.extends_command_line:
            return
        for path in self.package.files.paths:
            folder, name = posixpath.split(path)
            if folder not in FOLDERS or not name.endswith(".py") or path in self.installed or role_of(path) != "run":
                continue
            file = self.package.modules.at(path)
            if file is None or not is_node(file) or not starts_itself(file) or self.is_named(path):
                continue
            yield path, file.functions.get("main", Span(0, 0))

    def is_named(self, path: str) -> bool:
        """Return whether a README or another file names a script, or git ignores it."""
        name = posixpath.basename(path)
        return self.package.files.absent.is_ignored(path) or any(name in text for text in self.nodes.texts)


def is_node(file: PythonFile) -> bool:
    return any(each.module.partition(".")[0] == "rclpy" and not each.is_for_typing for each in file.imports)
