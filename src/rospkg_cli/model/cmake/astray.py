"""Executables and scripts that are installed where `ros2 run` and launch files don't look."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from ..launch.file import LaunchFile
from ..unreadable import UnreadableError
from .copying import copies
from .installs import InstallRule
from .links import Links
from .package import CMakePackage
from .table import Table
from .words import Word

ROS = re.compile(r"rclcpp|rclpy|rclcpp_\w+|.*_(msgs|interfaces)|.*_(msgs|interfaces)_TARGETS")
IMPORTS_ROS = re.compile(r"^\s*(?:import|from)\s+rclpy\b", re.MULTILINE)


@dataclass(frozen=True)
class Astray:
    word: Word
    name: str
    """Of the file that is installed."""
    place: str
    rule: InstallRule
    started: bool
    """Whether a launch file or the README starts it."""


@dataclass(frozen=True)
class AstrayExecutables:
    package: CMakePackage
    launches: tuple[LaunchFile, ...]

    def all(self) -> Iterator[Astray]:
        """Yield each executable that is meant for `ros2 run` and does not stand in lib/<package>."""
        cmake, table = self.package.cmake, Table(self.package.cmake, self.package.facts.name)
        for rule in cmake.installs:
            if rule.call.maybe or rule.call.testing:
                continue
            for word in rule.items:
                target = cmake.target(word.text) if rule.kind == "TARGETS" else None
                if target is not None and target.executable and not target.call.testing:
                    place, name = table.place(rule, target), table.file_name(target)
                    if self.is_wrong(place) and (self.starts(name) or place != "bin" or self.uses_ros(target.name)):
                        yield Astray(word, name, place or "", rule, self.starts(name))
            if rule.kind == "PROGRAMS" and rule.destination is not None and self.is_wrong(rule.destination):
                yield from self.scripts(rule, rule.destination)

    def scripts(self, rule: InstallRule, place: str) -> Iterator[Astray]:
        for copy in copies(rule, self.package.cmake.package):
            name = copy.destination.rpartition("/")[2]
            if self.starts(name) or IMPORTS_ROS.search(self.text(copy.source)):
                yield Astray(copy.item, name, place, rule, self.starts(name))

    def is_wrong(self, place: str | None) -> bool:
        """Return whether a place is known, relative, and neither lib/<package> nor below it."""
        right = f"lib/{self.package.facts.name}"
        return place is not None and not place.startswith("/") and not f"{place}/".startswith(f"{right}/")

    def uses_ros(self, target: str) -> bool:
        links = Links(self.package.cmake)
        return any(ROS.fullmatch(link.word.text.partition("::")[0].strip("${}")) for link in links.of(target))

    def starts(self, name: str) -> bool:
        return name in self.started

    @cached_property
    def started(self) -> frozenset[str]:
        """The executables of this package that its launch files or its README start."""
        own = self.package.facts.name
        found: set[str] = set()
        for file in self.launches:
            for node in file.nodes:
                executable = node.executable.literal if node.executable else None
                if executable and node.package and node.package.literal == own:
                    found.add(executable)
        run = re.compile(rf"ros2\s+run\s+{re.escape(own)}\s+([\w.-]+)")
        for path in self.package.cmake.package.paths:
            if path.rpartition("/")[2].lower().startswith("readme"):
                found |= set(run.findall(self.text(path)))
        return frozenset(found)

    def text(self, path: str) -> str:
        try:
            return self.package.cmake.package.source(path).text
        except UnreadableError:
            return ""
