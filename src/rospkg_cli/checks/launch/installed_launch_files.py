"""Rule inputs: the launch files of a package together, as `ros2 launch` finds them by their names."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.install_table import InstalledFile, InstallTable
from ...package.launch.launch_file import LaunchFile
from ...package.package_facts import PackageFacts
from ...ros.launch_entities import LAUNCH_SUFFIXES
from ...ros.share_layout import LAUNCH

ENDING = regex(r"(?:\.launch|\.py|\.xml|\.ya?ml)+$")
"""What a name ends with, however often it was written."""


@dataclass(frozen=True)
class InstalledLaunchFiles:
    table: InstallTable
    package: PackageFacts
    files: tuple[LaunchFile, ...]

    @cached_property
    def parts(self) -> frozenset[str]:
        """The files that others of the package include by their paths."""
        return frozenset(each.path for file in self.files for each in file.paths if each.use == "include")

    def doubles(self) -> Iterator[tuple[InstalledFile, str, tuple[str, ...]]]:
        """Yield each name that several installed launch files have: the row of the last, the name, and where they go.

        Files that others include by their path are parts of these, and not started by name.
        """
        named: dict[str, dict[str, InstalledFile]] = {}
        for path, row in self.table.below(f"share/{self.package.name}"):
            if LAUNCH.fullmatch(posixpath.basename(path)):
                named.setdefault(posixpath.basename(path), {})[path] = row
        for name, rows in named.items():
            free = [path for path in rows if path not in self.parts]
            maybe = [path for path, row in rows.items() if row.maybe]
            if len(rows) > 1 and free and len(maybe) < 2:  # of two that are under conditions, one may be there
                yield rows[free[-1]], name, tuple(sorted(rows))

    def oddly_named(self) -> Iterator[tuple[LaunchFile, str]]:
        """Yield the installed launch files whose names `ros2 launch` does not complete, and better names."""
        sources = {row.source for _, row in self.table.below(f"share/{self.package.name}")}
        for file in self.files:
            name = posixpath.basename(file.path)
            is_usual = file.path.endswith(LAUNCH_SUFFIXES) or file.path in self.parts or role_of(file.path) == "test"
            if file.path in sources and not is_usual and starts_something(file):
                suffix = "py" if file.frontend == "python" else file.frontend
                stem = ENDING.sub("", name)
                yield file, f"{stem}.launch.{suffix}"


def starts_something(file: LaunchFile) -> bool:
    """Return whether a file is one to be started: in Python, with the function that launch calls."""
    has_actions = file.frontend != "python" or bool(file.nodes or file.includes)
    return file.has_entry_point and not file.is_ros1 and has_actions
