"""C++ files with a node, a component or a plugin in them that no target compiles (CMK202)."""

from __future__ import annotations

import posixpath
import re
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
from ...package.launch.text import uncommented
from ...package.workspace import Workspace
from ...source import Span
from ..cmake.target_references import TargetReferences
from ..depends.compiled_sources import own_compiled
from ..depends.named_sources import are_sources_known
from ..depends.ros1_headers import Ros1Headers
from ..depends.ros1_sources import Ros1Sources
from .other_builds import is_built_elsewhere

SOURCES = (".cpp", ".cc", ".cxx", ".c++")
MAIN = regex(r"\bint\s+main\s*\(")
MADE_OF_NAMES = regex(r"\}(?:_\w+)?\.c|\bGLOB(?:_RECURSE)?\b")
"""What makes the names of sources of those of targets, `${name}.cpp`, or takes all that are there."""
STARTS_ROS = regex(r"\brclcpp::init\s*\(")
MACROS = {"RCLCPP_COMPONENTS_REGISTER_NODE": "component", "PLUGINLIB_EXPORT_CLASS": "plugin"}
ASIDE = frozenset(
    "example examples demo demos sample samples benchmark benchmarks old backup deprecated scripts".split()
)
PAGES = (".md", ".rst", ".sh", ".txt")
"""Files that tell, or do, what is to be started."""
LOADING = (".xml", ".yaml", ".yml", ".py", ".urdf", ".xacro")
"""Files that name classes to be loaded."""
OFFERS = "<class"
"""What stands in a description of plugins, which offers classes and loads none."""
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
            if source.path not in compiled and self.is_candidate(source.path) and not self.is_mentioned(source.path):
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
        package, name = self.package.facts.name, source.name
        if source.what == "node":
            started = re.compile(rf"\bros2[ \t]+run[ \t]+{re.escape(package)}[ \t]+{re.escape(name)}(?![\w.-])")
            is_started = bool(self.workspace.having("started_nodes", package, name))
            return is_started or any(map(started.search, self.texts(PAGES)))
        is_loaded = any((package, name) in facts.loaded_components for facts in self.workspace.packages)
        named = re.compile(rf"(?<![\w:]){re.escape(name)}(?![\w:])")
        texts = ((path, text) for path, text in self.named_texts(LOADING) if name in text and OFFERS not in text)
        return is_loaded or any(
            self.is_handed_out(path) and named.search(uncommented(path, text)) for path, text in texts
        )

    def existing_program(self, source: UncompiledSource) -> str:
        """Return the program that has the name of a node and is made of other files, for `ros2 run`; else ""."""
        target = self.package.cmake.target(source.name) if source.what == "node" else None
        if target is not None and target.is_executable and target.is_built:
            return f"the target `{source.name}`"
        has_program = source.what == "node" and source.name in self.package.facts.executables
        return f"the program `{source.name}`" if has_program else ""

    def is_handed_out(self, path: str) -> bool:
        """Return whether CMake names a description, to install or export it: else nothing finds the class by it."""
        file = path.rpartition("/")[2]
        return not path.endswith(".xml") or any(file in each.source.text for each in self.package.cmake.files)

    def texts(self, suffixes: tuple[str, ...]) -> Iterator[str]:
        return (text for _, text in self.named_texts(suffixes))

    def named_texts(self, suffixes: tuple[str, ...]) -> Iterator[tuple[str, str]]:
        files = self.package.cmake.package_files
        return ((path, files.readable_text(path)) for path in files.paths if path.endswith(suffixes))

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

    def is_mentioned(self, path: str) -> bool:
        """Return whether a CMake file has the name, in a comment too, or a file of the package includes it.

        The name without its ending counts as well, but not that of an XML or YAML file; where it is that of a target
        and no file makes sources of names, among sources alone.
        """
        name = posixpath.basename(path)
        stem, texts = posixpath.splitext(name)[0], [file.source.text for file in self.package.cmake.files]
        target, has_file = self.package.cmake.target(stem), self.package.cmake.package_files.has_file
        is_whole = target is not None and all(has_file(word.text) for word in target.sources)  # CMK102 reports others
        is_target = is_whole and not any(MADE_OF_NAMES.search(each) for each in texts)
        word = re.compile(rf"(?<![\w.-]){re.escape(name if is_target else stem)}(?!\.(?:xml|ya?ml)\b)(?![\w-])")
        is_source = stem in self.source_names or name in self.included
        return is_source or any(word.search(text) for text in texts)

    @cached_property
    def source_names(self) -> frozenset[str]:
        """The last parts of the sources of all targets, as they are written."""
        words = (word for target in self.package.cmake.targets for word in target.sources)
        return frozenset(posixpath.basename(word.text) for word in words)

    @cached_property
    def included(self) -> frozenset[str]:
        return frozenset(posixpath.basename(each.path) for source in self.sources for each in source.includes)

    @cached_property
    def registered(self) -> frozenset[str]:
        """The classes that what is compiled registers, so that they can be loaded without any other file."""
        compiled = own_compiled(self.package.cmake, self.sources) or set()
        calls = (call for each in self.sources if each.path in compiled for call in each.calls_to(*MACROS))
        return frozenset(call.arguments[0].text.strip() for call in calls if call.arguments)

    def judged(self, source: CppFile) -> Iterator[UncompiledSource]:
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
