"""Files and folders that CMake commands refer to: sources, tests, parameters, folders, and what is installed."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from typing import Literal

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cmake.targets import targets_of
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass, replace
from .cmake_project import CMake
from .made_paths import MadePaths
from .needed_files import needed_files

Use = Literal["source", "install", "folder", "test", "parameters", "subdirectory", "include", "extras", "matching"]
"""Of what is `matching`, CMake 3.25 says nothing: a folder with FILES_MATCHING that is not there."""


@dataclass(frozen=True)
class ReferencedPath:
    """A path of the package that a command needs to exist."""

    path: str
    word: Word
    use: Use
    call: EvaluatedCommand


@dataclass(frozen=True)
class ReferencedPaths:
    cmake: CMake

    def missing(self) -> Iterator[ReferencedPath]:
        """Yield what is referenced and does not exist, each argument once, where nothing can make it."""
        expected = self.cmake.package_files.absent
        for named in self.absent():
            if not self.made.is_made(named.path) and not expected.is_expected(named.path):
                yield named

    def absent(self) -> Iterator[ReferencedPath]:
        """Yield what is referenced and not there, each argument once."""
        seen: set[tuple[str, int, str]] = set()
        for named in self.all():
            key = (named.word.path, named.word.span.start, named.path)
            if key not in seen and not self.is_there(named):
                seen.add(key)
                yield named

    def ignored(self) -> Iterator[ReferencedPath]:
        """Yield each installed folder once that git ignores, that nothing makes, and that people fill by hand."""
        ignored, seen = self.cmake.package_files.absent.is_ignored, set[str]()
        for each in self.absent():
            is_by_hand = each.use == "folder" and each.path.rstrip("/") in BY_HAND and each.path not in seen
            is_sure = is_by_hand and not each.word.maybe and not each.call.maybe and not self.made.is_made(each.path)
            if is_sure and not self.made.is_worked_in and ignored(each.path):
                seen.add(each.path)
                yield each

    def all(self) -> Iterator[ReferencedPath]:
        for target in self.cmake.targets:
            yield from self.named(target.sources, "source", target.call)
        for target in targets_of(self.cmake.unreachable):
            yield from self.named(target.sources, "source", replace(target.call, maybe=True))
        for call in self.cmake.named("target_sources"):
            yield from self.named(sources_in(call), "source", call)
        for call in self.cmake.calls:
            for purpose, words in needed_files(call) if call.name not in self.cmake.functions else ():
                yield from self.named(words, purpose, call)
        yield from self.read_files()
        for rule in self.cmake.installs:
            if rule.kind in ("FILES", "PROGRAMS", "DIRECTORY") and not rule.optional and rule.call.name in INSTALLERS:
                use: Use = "folder" if rule.kind == "DIRECTORY" else "install"
                use = "matching" if rule.matching else use
                yield from self.named(rule.items, use, rule.call)

    def read_files(self) -> Iterator[ReferencedPath]:
        """Yield the files that `add_subdirectory()` and `include()` read."""
        for call in self.cmake.named("add_subdirectory"):
            for named in self.named(call.words[:1], "subdirectory", call):
                yield replace(named, path=f"{named.path}/CMakeLists.txt".lstrip("/"))
        for call in self.cmake.named("include"):
            if call.words and call.texts[0].endswith(".cmake") and "OPTIONAL" not in call.texts:
                yield from self.named(call.words[:1], "include", call)

    def named(self, words: Iterable[Word], use: Use, call: EvaluatedCommand) -> Iterator[ReferencedPath]:
        for word in words:
            path = path_in_package(word.text, call.folder)
            if path is not None and word.text and not word.text.startswith("-"):
                yield ReferencedPath(path, word, use, call)

    def is_there(self, named: ReferencedPath) -> bool:
        files = self.cmake.package_files
        path = named.path
        if not path or files.is_there(path):
            return True
        return named.use == "source" and is_prefix_of_any(f"{path}.", files.paths)

    @cached_property
    def made(self) -> MadePaths:
        return MadePaths(self.cmake)


BY_HAND = frozenset("launch config params param urdf rviz include meshes worlds".split())
"""Folders whose files are never generated."""
INSTALLERS = frozenset({
    "install", "ament_auto_package", "autoware_ament_auto_package", "ament_python_install_package",
    "ament_python_install_module", "pluginlib_export_plugin_description_file",
})  # fmt: skip


def is_prefix_of_any(start: str, paths: Sequence[str]) -> bool:
    """Return whether one of some sorted paths begins with a text."""
    at = bisect_left(paths, start)
    return at < len(paths) and paths[at].startswith(start)


def sources_in(call: EvaluatedCommand) -> list[Word]:
    words = call.words[1:]
    return [] if "FILE_SET" in call.texts else [w for w in words if w.text not in ("PRIVATE", "PUBLIC", "INTERFACE")]
