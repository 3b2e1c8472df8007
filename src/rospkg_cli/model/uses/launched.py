"""Launch files against declarations: the packages that they need and package.xml does not name."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from ...ros.launch import LAUNCH_PACKAGES
from ..files import PackageFiles
from ..launch.file import LaunchFile
from ..launch.uses import PackageUse, package_uses
from .declared import Declared
from .python import OwnModules
from .roles import role_of
from .serving import serving_import

BROUGHT_BY = {
    "ros2launch": LAUNCH_PACKAGES,
    "launch_ros": frozenset({"launch", "rclpy", "python3-yaml", "ament_index_python"}),
    "launch_xml": frozenset({"launch"}),
    "launch_yaml": frozenset({"launch"}),
    "launch_testing": frozenset({"launch", "ament_index_python"}),
    "launch_testing_ros": frozenset({"launch", "launch_ros", "launch_testing", "ament_index_python"}),
    "launch_testing_ament_cmake": frozenset({"launch_testing"}),
    "launch_pytest": frozenset({"launch", "launch_testing"}),
}
"""What may be used inside of a launch file because something else was declared that is of no use without it."""


@dataclass(frozen=True)
class Launched:
    """The launch files of a package, and what it declares."""

    declared: Declared
    files: PackageFiles
    launch_files: tuple[LaunchFile, ...]

    @cached_property
    def brought(self) -> frozenset[str]:
        return frozenset().union(*(BROUGHT_BY.get(name, ()) for name in self.declared.names))

    def missing(self, *, tests: bool) -> Iterator[tuple[str, tuple[PackageUse, ...]]]:
        """Yield each package that is needed and not declared, with the places that need it."""
        found: dict[str, list[PackageUse]] = {}
        for file in self.launch_files if self.declared.judged else ():
            if (role_of(file.path) == "test") is tests:
                for use in [*package_uses(file), *([] if tests else self.imported(file))]:
                    if not self.declared.has([use.name]) and use.name not in self.brought:
                        found.setdefault(use.name, []).append(use)
        yield from ((name, tuple(uses)) for name, uses in found.items())

    def imported(self, file: LaunchFile) -> Iterator[PackageUse]:
        """Yield what a Python launch file imports and nothing declared serves."""
        own = OwnModules(self.files)
        for each in file.imports:
            if each.level or own.has(each.module, file.path):
                continue
            name = serving_import(self.declared, each)
            if name is not None:
                yield PackageUse(name, file.path, each.span, f"imports `{each.module}` of")
