"""Rule input: whether a file is installed where `ros2 run`, `ros2 launch` or an import finds it."""

from __future__ import annotations

import posixpath
import re
from functools import cached_property

from ..files import PackageFiles
from ..light_dataclasses import dataclass
from ..package.file_role import role_of
from ..package.install_table import InstallKind, InstallTable
from ..package.launch.live_text import MARKUP as XML
from ..package.launch.live_text import live_text
from .module_mentions import SCRIPTS

KINDS: tuple[InstallKind, ...] = ("executable", "share", "module", "other")


@dataclass(frozen=True)
class HowInstalled:
    files: PackageFiles
    table: InstallTable | None = None

    @cached_property
    def installed(self) -> frozenset[str]:
        return frozenset(row.source for row in self.table.rows) if self.table is not None else frozenset()

    @cached_property
    def shared(self) -> frozenset[str]:
        """The files that go to share directories."""
        rows = self.table.rows if self.table is not None else ()
        return frozenset(row.source for row in rows if row.destination.startswith("share/"))

    def is_uninstalled(self, path: str) -> bool:
        """Return whether no rule installs a file; XML counts only in share directories, where `ros2 launch` looks."""
        table = self.table
        installed = self.shared if path.endswith(XML) else self.installed
        return table is not None and all(map(table.knows, KINDS)) and path not in installed

    def is_no_more_than_data(self, path: str) -> bool:
        """Return whether a script is installed only as data, if at all, where neither `ros2 run` nor imports find it.

        Where some install rules are not known, it is a script in a folder that no CMakeLists.txt names.
        """
        if self.table is None or not path.endswith(".py") or role_of(path) != "run":
            return False
        rows = [row for row in self.table.rows if row.source == path]
        if rows or self.is_uninstalled(path):
            return all(row.what in ("share", "other") for row in rows)
        folders = "|".join(map(re.escape, posixpath.dirname(path).split("/")))
        word = re.compile(rf"(?<![\w-])(?:{folders})(?![\w-])")
        return bool(folders) and not any(
            word.search(live_text(self.files, each)) for each in self.files.matching("*CMakeLists.txt")
        )

    def is_no_program(self, path: str) -> bool:
        """Return whether setup.py puts a file among the programs, but `ros2 run` skips it, as it is not executable."""
        rows = [row for row in self.table.rows if row.source == path] if self.table is not None else []
        is_data = bool(rows) and all(row.what == "executable" and not row.entry for row in rows)
        is_data = is_data and all(row.path == "setup.py" for row in rows) and not self.files.is_executable(path)
        return is_data and SCRIPTS.search(self.files.readable_text("setup.py")) is None  # which makes it executable

    def is_swept(self, path: str) -> bool:
        """Return whether a script is only installed with its folder: it is not executable, and has no `#!` line."""
        rows = [row for row in self.table.rows if row.source == path] if self.table is not None else []
        is_data = bool(rows) and all(row.what in ("share", "other", "executable") and not row.entry for row in rows)
        is_data = is_data and all(row.path != "setup.py" for row in rows)  # setuptools makes `scripts` executable
        is_plain = is_data and path.endswith(".py") and not self.files.is_executable(path)
        return is_plain and role_of(path) == "run" and not self.files.readable_text(path).startswith("#!")
