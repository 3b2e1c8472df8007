"""C++ files with a node, a component or a plugin in them that no target compiles (CMK202)."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from functools import cached_property
from typing import Literal

from ...languages.cpp.code_text import code_text
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.foreign_commands import may_make_targets
from ...package.cmake.referenced_paths import ReferencedPaths
from ...package.file_role import is_set_aside, role_of
from ...package.workspace import Workspace
from ...source import Span
from ..cmake.target_references import TargetReferences
from ..depends.compiled_sources import own_compiled
from ..depends.named_sources import are_sources_known
from ..depends.ros1_headers import Ros1Headers
from ..depends.ros1_sources import Ros1Sources
from .mentioned_sources import MentionedSources
from .other_builds import is_built_elsewhere
from .wanted_nodes import WantedNodes

SOURCES = (".cpp", ".cc", ".cxx", ".c++")
MAIN = regex(r"\bint\s+main\s*\(")
STARTS_ROS = regex(r"\brclcpp::init\s*\(")
MACROS = {"RCLCPP_COMPONENTS_REGISTER_NODE": "component", "PLUGINLIB_EXPORT_CLASS": "plugin"}
ASIDE = frozenset(
    "example examples demo demos sample samples benchmark benchmarks old backup deprecated scripts".split()
)
SPARE = frozenset("template templates new tmp wip unused".split())
"""Words of a file's name that say that it is not built."""
WORD = regex(r"[A-Za-z]+")


@dataclass(frozen=True, slots=True)
class UncompiledSource:
    path: str
    span: Span
    what: Literal["node", "component", "plugin"]
    name: str
    """Of the program, as it may be called, or of the class."""


@dataclass(frozen=True)
class UncompiledSources:
    package: CMakePackage
    sources: tuple[CppFile, ...]
    workspace: Workspace

    def all(self) -> Iterator[UncompiledSource]:
        """Yield the files that no target has and no CMake file mentions; nothing where sources can't be known."""
        compiled = own_compiled(self.package.cmake, self.sources) or set()
        for source in self.sources if self.are_known else ():
            if source.path not in compiled and self.is_candidate(source.path) and not self.mentioned.has(source.path):
                yield from self.judged(source)

    @cached_property
    def ros1(self) -> Ros1Sources:
        headers = Ros1Headers(self.package.facts, self.package.cmake.package_files, self.workspace)
        return Ros1Sources(headers, self.package.cmake, self.sources)

    @cached_property
    def are_known(self) -> bool:
        """Whether the sources of all targets are known, and no other rule reports a target or a source."""
        cmake = self.package.cmake
        is_known = are_sources_known(cmake) and cmake.ends_a_package and not cmake.includes_unknown_files
        if not self.package.is_ament or not is_known or may_make_targets(cmake):
            return False
        if any(each.kind == "target" for each in TargetReferences(cmake).broken()):
            return False  # CMK110 reports the target, which would compile the file
        # CMK102 reports the name, which may be intended for the file
        return not any(each.use == "source" for each in ReferencedPaths(cmake).missing())

    def is_wanted(self, source: UncompiledSource) -> bool:
        """Return whether a launch file starts or loads what a file holds, a page does so, or a text names the class."""
        is_node = source.what == "node"
        return self.uses.is_node_wanted(source.name) if is_node else self.uses.is_class_wanted(source.name)

    def existing_program(self, source: UncompiledSource) -> str:
        """Return the program that has the name of a node and is made of other files, for `ros2 run`; else ""."""
        return self.uses.existing_program(source.name) if source.what == "node" else ""

    @cached_property
    def uses(self) -> WantedNodes:
        return WantedNodes(self.package, self.workspace)

    @cached_property
    def mentioned(self) -> MentionedSources:
        return MentionedSources(self.package.cmake, self.sources)

    def is_candidate(self, path: str) -> bool:
        """Return whether a file lies where programs do, and git keeps it."""
        *folders, name = path.lower().split("/")
        is_spare = not (ASIDE.isdisjoint(folders) and SPARE.isdisjoint(WORD.findall(name.replace("_", " "))))
        is_kept = is_spare or is_set_aside(path)
        is_run = role_of(path) == "run" and not is_kept and not self.is_elsewhere(path)
        return is_run and path.endswith(SOURCES) and not self.package.cmake.package_files.absent.is_ignored(path)

    def is_elsewhere(self, path: str) -> bool:
        """Return whether a file of another build lies around a file: it may be built alone."""
        cmake = self.package.cmake
        return is_built_elsewhere(cmake.package_files, path, frozenset(file.path for file in cmake.files))

    @cached_property
    def registered(self) -> frozenset[str]:
        """The classes that what is compiled registers, so that they can be loaded without any other file."""
        compiled = own_compiled(self.package.cmake, self.sources) or set()
        calls = (call for each in self.sources if each.path in compiled for call in each.calls_to(*MACROS))
        return frozenset(call.arguments[0].text.strip() for call in calls if call.arguments)

    def judged(self, source: CppFile) -> Iterator[UncompiledSource]:
        """Yield the component or plugin that a file registers, each call of it, or else the node that it starts."""
        for call in source.calls_to(*MACROS):
            if not call.is_conditional:
                what: Literal["component", "plugin"] = "plugin" if call.name.startswith("PLUGIN") else "component"
                name = call.arguments[0].text.strip() if call.arguments else ""
                if name not in self.registered:
                    yield UncompiledSource(source.path, call.span, what, name)
                return
        code = code_text(source.source.text)
        if (found := MAIN.search(code)) is not None and STARTS_ROS.search(code) is not None:
            name = posixpath.splitext(posixpath.basename(source.path))[0]
            yield UncompiledSource(source.path, Span(found.start(), found.end() - 1), "node", name)
