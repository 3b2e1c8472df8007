"""Files and folders that CMake commands refer to: sources of targets, and what is installed."""

from __future__ import annotations

import posixpath
from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

from ...languages.cmake.evaluated_command import EvaluatedCommand, flags_and_values, path_in_package
from ...languages.cmake.targets import targets_of
from ...languages.cmake.values import Word
from .cmake_project import CMake

Use = Literal["source", "install", "folder"]

WRITES = {
    "configure_file": 1, "configure_package_config_file": 1, "write_basic_package_version_file": 0, "em_expand": 3,
    "generate_export_header": -1,
}  # fmt: skip
"""Commands that write a file, and which argument names it."""
LISTS_OUTPUTS = frozenset({"add_custom_command", "add_custom_target", "externalproject_add"})
OUTPUT_KEYWORDS = frozenset({"OUTPUT", "BYPRODUCTS", "EXPORT_FILE_NAME", "SOURCE_DIR", "DESTINATION"})
WRITES_FILES = frozenset({"WRITE", "APPEND", "GENERATE", "COPY", "DOWNLOAD", "TOUCH", "CONFIGURE", "COPY_FILE",
                          "CREATE_LINK", "RENAME", "MAKE_DIRECTORY", "ARCHIVE_EXTRACT"})  # fmt: skip


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
        """Yield what is referenced and does not exist, each argument once."""
        seen: set[tuple[str, int, str]] = set()
        for named in self.all():
            key = (named.word.path, named.word.span.start, named.path)
            if key not in seen and not self.is_there(named):
                seen.add(key)
                yield named

    def all(self) -> Iterator[ReferencedPath]:
        for target in self.cmake.targets:
            yield from self.named(target.sources, "source", target.call)
        for target in targets_of(self.cmake.unreachable):
            yield from self.named(target.sources, "source", replace(target.call, maybe=True))
        for call in self.cmake.named("target_sources"):
            yield from self.named(sources_in(call), "source", call)
        for rule in self.cmake.installs:
            if rule.kind in ("FILES", "PROGRAMS", "DIRECTORY") and not rule.optional and rule.call.name in INSTALLERS:
                use: Use = "folder" if rule.kind == "DIRECTORY" else "install"
                yield from self.named(rule.items, use, rule.call)

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
        if named.use == "source" and is_prefix_of_any(f"{path}.", files.paths):
            return True
        return path in self.written_paths or posixpath.basename(path) in self.written_names

    @property
    def calls(self) -> tuple[EvaluatedCommand, ...]:
        return self.cmake.calls + self.cmake.unreachable

    @cached_property
    def written_paths(self) -> frozenset[str]:
        """The paths in the package that commands write."""
        found = (path_in_package(word.text, call.folder) for call in self.calls for word in files_written_by(call))
        return frozenset(path for path in found if path)

    @cached_property
    def written_names(self) -> frozenset[str]:
        """The names of all files that commands write, wherever."""
        words = (word for call in self.calls for word in files_written_by(call))
        return frozenset(posixpath.basename(word.text) for word in words if not word.text.endswith("\0"))


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


def files_written_by(call: EvaluatedCommand) -> Iterator[Word]:
    """Yield the names of the files that a command writes when it configures or builds."""
    if call.name in WRITES and WRITES[call.name] >= 0:
        yield from call.words[WRITES[call.name] :][:1]
    if call.name == "file" and call.words and call.texts[0] in WRITES_FILES:
        yield from call.words[1:]
    if call.name == "set_source_files_properties" and "GENERATED" in call.texts:
        yield from call.words[: call.texts.index("PROPERTIES")] if "PROPERTIES" in call.texts else ()
    if call.name in LISTS_OUTPUTS or call.name == "generate_export_header":
        _, values, _ = flags_and_values(call.words, (), (), (*OUTPUT_KEYWORDS, *OTHER_KEYWORDS))
        for keyword in OUTPUT_KEYWORDS:
            yield from values.get(keyword, [])


OTHER_KEYWORDS = ("COMMAND", "DEPENDS", "WORKING_DIRECTORY", "COMMENT", "VERBATIM", "MAIN_DEPENDENCY", "ARGS", "TARGET",
                  "POST_BUILD", "PRE_BUILD", "PRE_LINK", "SOURCES", "ALL")  # fmt: skip
