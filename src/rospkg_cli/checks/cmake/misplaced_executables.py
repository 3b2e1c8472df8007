"""Executables and scripts that are installed where `ros2 run` and launch files don't find them."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Mapping
from functools import cached_property

from ...languages.cmake.values import Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_install_table import CMakeTableBuilder
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.copied_files import copied_files
from ...package.cmake.install_rule import InstallRule
from .left_out_nodes import is_node
from .node_programs import NodePrograms
from .side_programs import has_side_name
from .started_paths import StartedPaths

IMPORTS_ROS = regex(r"^[ \t]*(?:import|from)\s+rclpy\b", re.MULTILINE)


@dataclass(frozen=True)
class MisplacedExecutable:
    word: Word
    name: str
    """Of the file that is installed."""
    destination: str
    rule: InstallRule
    is_started: bool
    """Whether a launch file or the README starts it."""
    is_node: bool
    """Whether it is a node, as far as that is known."""
    is_tool: bool = False
    """Whether it lies in bin/ on purpose: it runs no node, or others of its kind go to lib/<package>; or it is a test
    or a demonstration by its name, and others go there."""


@dataclass(frozen=True)
class MisplacedExecutables:
    package: CMakePackage

    def all(self) -> Iterator[MisplacedExecutable]:
        """Yield each executable for `ros2 run` that is not installed in lib/<package>; code may link it."""
        found = [] if any(rule.kind == "CODE" for rule in self.package.cmake.installs) else list(self.anywhere())
        right = {row.destination for row in self.table.rows()} if found else set()
        for each in found:
            if f"lib/{self.package.facts.name}/{each.name}" not in right:
                yield each

    @cached_property
    def table(self) -> CMakeTableBuilder:
        return CMakeTableBuilder(self.package.cmake, self.package.facts.name)

    def anywhere(self) -> Iterator[MisplacedExecutable]:
        """Yield each executable that a rule installs into another folder, whatever other rules do with it."""
        cmake, artifacts = self.package.cmake, self.table.artifacts
        for rule in cmake.installs:
            if rule.call.maybe or rule.destination in self.of_own_projects.get(rule.call.path, ()):
                continue
            for word in rule.items:
                target = cmake.target(word.text) if rule.kind == "TARGETS" else None
                if target is not None and target.is_executable:
                    place, name = artifacts.destination(rule, target), artifacts.file_name(target)
                    is_intended = place == "bin" and (rule.call.testing or f"/bin/{name}" in self.paths.pages)
                    is_intended = is_intended or self.paths.is_named_with(posixpath.basename(place or ""), name)
                    if self.is_wrong(place) and not is_intended:
                        ros = self.programs.uses_ros(target.name) and self.programs.may_be_node(target)
                        is_other = place == "bin" or has_side_name(name)
                        tool = self.has_others and is_other
                        tool = tool or (place == "bin" and not self.programs.runs_node(target))
                        yield MisplacedExecutable(word, name, place or "", rule, self.starts(name), ros, tool)
            if rule.kind == "PROGRAMS" and rule.destination is not None and self.is_wrong(rule.destination):
                yield from self.scripts(rule, rule.destination)
            elif rule.kind in ("DIRECTORY", "FILES") and self.is_for_others(rule.destination):
                yield from self.nodes(rule)

    @cached_property
    def has_others(self) -> bool:
        """Whether other programs that CMake builds go to lib/<package>."""
        right = f"lib/{self.package.facts.name}"
        built = ((rule, word) for rule in self.package.cmake.installs if rule.kind == "TARGETS" for word in rule.items)
        targets = ((rule, self.package.cmake.target(word.text)) for rule, word in built)
        programs = ((rule, target) for rule, target in targets if target is not None and target.is_executable)
        return any(self.table.artifacts.destination(rule, target) == right for rule, target in programs)

    def is_for_others(self, place: str | None) -> bool:
        """Return whether a folder is bin/, or in share/, where nothing is started."""
        return place == "bin" or f"{place}/".startswith(f"share/{self.package.facts.name}/")

    def nodes(self, rule: InstallRule) -> Iterator[MisplacedExecutable]:
        """Yield the executable nodes in Python of a rule for other files, where what it names holds nothing else."""
        files = self.package.cmake.package_files
        copies = list(copied_files(rule, files))
        others = {copy.item for copy in copies if not is_node(copy.source, files)}
        for copy in (each for each in copies if each.item not in others):
            place, _, name = copy.destination.rpartition("/")
            if files.is_executable(copy.source) and not self.paths.runs_by_path(name):
                yield MisplacedExecutable(copy.item, name, place, rule, self.starts(name), is_node=True)

    @cached_property
    def of_own_projects(self) -> Mapping[str, frozenset[str]]:
        """The folder for the programs of each CMake file below that names a project of its own."""
        calls = [call for call in self.package.cmake.named("project") if call.folder and call.texts]
        return {call.path: frozenset({f"lib/{call.texts[0]}"}) for call in calls}

    def scripts(self, rule: InstallRule, place: str) -> Iterator[MisplacedExecutable]:
        for copy in copied_files(rule, self.package.cmake.package_files):
            name = copy.destination.rpartition("/")[2]
            ros = IMPORTS_ROS.search(self.package.cmake.package_files.readable_text(copy.source)) is not None
            if self.starts(name) or ((ros or place == "bin") and not self.paths.is_run_by_path(copy, name)):
                yield MisplacedExecutable(copy.item, name, place, rule, self.starts(name), ros)

    def is_wrong(self, place: str | None) -> bool:
        """Return whether a place is known, relative, and neither lib/<package> nor below it."""
        right = f"lib/{self.package.facts.name}"
        return place is not None and not place.startswith("/") and not f"{place}/".startswith(f"{right}/")

    @cached_property
    def paths(self) -> StartedPaths:
        return StartedPaths(self.package)

    @cached_property
    def programs(self) -> NodePrograms:
        return NodePrograms(self.package)

    def starts(self, name: str) -> bool:
        return name in self.programs.started
