"""`file(GLOB …)` that matches no file, although another folder holds what it looks for."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property
from itertools import takewhile

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cmake.regex import glob
from ...languages.cmake.targets import OPTIONS as OPTIONS_OF_TARGETS
from ...languages.cmake.values import Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake

READ = (".cpp", ".cc", ".cxx", ".c", ".cu", ".msg", ".srv", ".action", ".idl", ".proto", ".py", ".yaml")
"""Endings of what is lost where it is not found; headers are listed for editors alone."""
OPTIONS = frozenset({"CONFIGURE_DEPENDS", "FOLLOW_SYMLINKS"})
HEADERS = (".h", ".hh", ".hpp", ".hxx", ".cuh")
INTERFACES = "rosidl_generate_interfaces"
MAKING = frozenset(
    "add_executable add_library ament_add_gmock ament_add_gtest cuda_add_executable cuda_add_library "
    f"pybind11_add_module {INTERFACES}".split()
)
"""Commands that make something of files, behind its name, and stop without any."""
KEYWORD = regex(r"[A-Z_]+")
WITH_VALUE = frozenset({"RELATIVE", "LIST_DIRECTORIES"})


@dataclass(frozen=True)
class EmptyGlob:
    word: Word
    variable: str
    near: str
    """The pattern that matches, relative to the folder of the CMake file."""
    is_needed: bool = True
    """Whether something is made of these files alone: without them CMake stops."""


@dataclass(frozen=True)
class EmptyGlobs:
    cmake: CMake

    def all(self) -> Iterator[EmptyGlob]:
        """Yield the only pattern of a glob where it matches nothing, and nearly the same one does."""
        for call in self.cmake.named("file"):
            patterns = patterns_of(call)
            if len(patterns) != 1 or call.maybe or not self.is_used(call.texts[1]):
                continue
            path = path_in_package(patterns[0].text, call.folder)
            if path is None or not path.endswith(READ) or "*" not in path or "[" in path or self.is_found(call, path):
                continue
            if not self.cmake.package_files.absent.is_expected(path) and (folder := self.holding(path)) is not None:
                near = posixpath.join(posixpath.relpath(folder or ".", call.folder or "."), posixpath.basename(path))
                yield EmptyGlob(patterns[0], call.texts[1], near.removeprefix("./"), self.is_needed(call.texts[1]))

    def is_needed(self, variable: str) -> bool:
        """Return whether a command makes something of what a variable holds and of nothing else but headers."""
        return any(self.is_all(variable, call) for call in self.cmake.calls if call.name in MAKING)

    def is_all(self, variable: str, call: EvaluatedCommand) -> bool:
        given = [each.text for each in call.command.arguments[1:] if each.text not in OPTIONS_OF_TARGETS]
        if call.name == INTERFACES:
            given = list(takewhile(lambda text: not KEYWORD.fullmatch(text), given))
        others = [text for text in given if text != f"${{{variable}}}"]
        return len(others) < len(given) and all(text in self.headers or text.endswith(HEADERS) for text in others)

    @cached_property
    def headers(self) -> frozenset[str]:
        """What reads a variable that holds headers alone."""
        every: dict[str, list[Word]] = {}
        for call in self.cmake.named("file"):
            if found := patterns_of(call):
                every.setdefault(call.texts[1], []).extend(found)
        alone = (name for name, words in every.items() if all(word.text.endswith(HEADERS) for word in words))
        return frozenset(f"${{{name}}}" for name in alone)

    def is_used(self, variable: str) -> bool:
        """Return whether a file reads a variable, and none asks whether there is anything in it."""
        texts = [file.source.text for file in self.cmake.files]
        asked = re.compile(rf"\bif\s*\(\s*(?:NOT\s+)?{re.escape(variable)}\b")
        return any(f"${{{variable}}}" in text for text in texts) and not any(map(asked.search, texts))

    def is_found(self, call: EvaluatedCommand, path: str) -> bool:
        """Return whether a pattern matches a file; one of GLOB_RECURSE looks below its folder too."""
        every = self.cmake.package_files.every
        if call.texts[0].upper() != "GLOB_RECURSE":
            return glob(path, every) != []
        folder, name = posixpath.split(path)
        depth = len(folder.split("/")) if folder else 0
        inside = (each for each in every if glob(folder, ["/".join(each.split("/")[:-1][:depth])]) != [])
        return glob(name, map(posixpath.basename, inside)) != []

    def holding(self, path: str) -> str | None:
        """Return the folder that holds such files: the only one, or the only one of the same name."""
        folder, name = posixpath.split(path)
        fits = {posixpath.dirname(each) for each in self.files if glob(name, [posixpath.basename(each)])}
        same = {each for each in fits if posixpath.basename(each) == posixpath.basename(folder)} if folder else set()
        found = same or fits
        return next(iter(found)) if len(found) == 1 else None

    @cached_property
    def files(self) -> tuple[str, ...]:
        return tuple(each for each in self.cmake.package_files.paths if "/." not in f"/{each}")


def patterns_of(call: EvaluatedCommand) -> list[Word]:
    """Return the patterns of `file(GLOB variable …)`; none for other forms of `file`."""
    if len(call.words) < 3 or call.texts[0].upper() not in ("GLOB", "GLOB_RECURSE"):
        return []
    found, before = [], ""
    for word in call.words[2:]:
        if before not in WITH_VALUE and word.text not in WITH_VALUE | OPTIONS:
            found.append(word)
        before = word.text
    return found
