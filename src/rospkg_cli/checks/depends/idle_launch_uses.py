"""Places of launch files that need a package, and that no launch of a robot reaches."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...package.python.python_imports import PackageImports
from ...source import Span
from ..launch.example_files import is_example
from ..launch.idle_parts import idle_parts
from ..launch.package_reference import PackageReference
from ..left_files import LeftFiles
from .launch_file_imports import is_imported, stem_of

FOR_DEMOS = regex(r"turtlesim|demo_nodes_\w+")
"""Packages of demos, which no robot needs."""


@dataclass(frozen=True)
class IdleLaunchUses:
    launch_files: tuple[LaunchFile, ...]
    python: PackageImports
    left: LeftFiles

    def is_for_examples(self, name: str, uses: Iterable[PackageReference]) -> bool:
        """Return whether only examples need a package, or it is one of the demos of ROS."""
        return FOR_DEMOS.fullmatch(name) is not None or all(is_example(use.path) for use in uses)

    def is_left(self, uses: Iterable[PackageReference]) -> bool:
        """Return whether each place is idle, or in a file that nothing installs and no page names."""
        return all(self.is_idle(use) or self.left.has(use.path) for use in uses)

    def is_idle(self, use: PackageReference) -> bool:
        """Return whether a place is in a function that nothing calls, or under a condition that never holds."""
        return any(each.holds(use.span) for each in self.idle.get(use.path, ()))

    @cached_property
    def idle(self) -> dict[str, tuple[Span, ...]]:
        """The idle parts of each launch file, by path."""
        modules = {module for each in self.python.files for one in each.imports for module in (one.module, *one.names)}
        names = {module.rpartition(".")[2] for module in modules}
        found: dict[str, tuple[Span, ...]] = {}
        for file in self.launch_files:
            is_helper = is_imported(file, self.launch_files) or stem_of(file.path) in names
            found[file.path] = tuple(idle_parts(file, is_imported=is_helper))
        return found
