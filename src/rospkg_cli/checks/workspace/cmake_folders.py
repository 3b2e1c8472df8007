"""Folders and sources that the CMake of a package names to build, or to have built."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

from ...languages.cmake.commands import COMMANDS
from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cmake.targets import MAKERS
from ...languages.cmake.values import SOURCE, Word
from ...package.cmake.cmake_project import CMake
from ...package.cmake.made_paths import FETCHES, values_of
from ...ros.read_table import words

TAKES_NAMES = ("add_executable", "add_library", "target_sources", "target_include_directories")
"""Commands whose first word is a target, and whose others may be paths."""
NO_BUILDS = ("install", "message", "ament_package", "ament_auto_package", "project")
"""Commands whose paths show no build: what they install is data."""


def named_folders(cmake: CMake | None) -> frozenset[str]:
    """Return the paths that CMake adds to the build, gives to a function of its own or of others, or writes out."""
    if cmake is None:
        return frozenset()
    pairs = ((word, call) for call in cmake.calls for word in paths_of(call))
    found = (path_in_package(word.text, call.folder) for word, call in pairs)
    return frozenset(path for path in found if path)


def paths_of(call: EvaluatedCommand) -> Iterator[Word]:
    """Yield the words that are paths: `arm` alone may be a package, a target or a value, `lib/arm` is none of these."""
    if call.name in NO_BUILDS:
        return
    if call.name == "add_subdirectory":
        yield from call.words[:1]
    elif call.name in TAKES_NAMES:
        yield from call.words[1:]
    elif call.name in FETCHES:
        yield from values_of(call, ("SOURCE_DIR",))
    elif call.name not in known_commands():
        yield from call.words
    else:
        yield from (word for word in call.words if word.text.startswith(SOURCE) or "/" in word.text)


@lru_cache(maxsize=1)
def known_commands() -> frozenset[str]:
    """The commands of CMake and ROS, most of which take names."""
    return frozenset({*words("cmake_commands.txt"), *COMMANDS, *MAKERS})
