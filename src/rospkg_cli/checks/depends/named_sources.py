"""Which source files the commands of CMake name: for tests, for the package itself, or in a comment."""

from __future__ import annotations

import posixpath
from collections.abc import Collection

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...lazy_regex import regex
from ...package.cmake.cmake_project import CMake
from ..cmake.switched_off import SwitchedOff
from .header_inclusions import HEADERS

LISTING = frozenset(
    {"add_executable", "add_library", "file", "install", "list", "set", "source_group", "target_sources"}
)

OBJECTS = regex(r"\$<TARGET_OBJECTS:[\w.+:-]+>")
"""What another target compiles."""


def named_sources(
    cmake: CMake, files: Collection[str], testing: bool, *, maybe: bool = True, off: SwitchedOff | None = None
) -> set[str]:
    """Return the files that commands name: those that run for tests alone with `testing`, else the others.

    With `off`, commands that are switched off are left out. Without `maybe`, commands and words under a condition that
    may not hold are left out, and commands that compile nothing by themselves. A header among the sources of a target
    is left out, as the compiler opens it only where a source includes it; with AUTOMOC it counts, as Qt's moc reads it.
    """
    bases: set[str] = set()
    has_moc = any("AUTOMOC" in text for call in cmake.calls for text in call.texts)
    for target in cmake.targets:
        base = path_in_package(target.folder.text, target.call.folder) if target.folder is not None else None
        if base is not None and target.call.testing is testing and (maybe or not target.call.maybe):
            bases.add(f"{base}/")
    found = {path for path in files if path.startswith(tuple(bases))} if bases else set()
    for call in cmake.calls:
        is_left = off is not None and (is_idle(call) or off.has(call))
        if call.testing is testing and not is_left and (maybe or not (call.maybe or is_idle(call))):
            paths = (path_in_package(word.text, call.folder) for word in call.words if maybe or not word.maybe)
            idle = () if has_moc or not lists_headers(call) else HEADERS
            found |= {path for path in paths if path is not None and path in files and not path.endswith(idle)}
    return found


def lists_headers(call: EvaluatedCommand) -> bool:
    """Return whether a command takes headers only to show them in editors, or to copy them, and opens none itself."""
    return call.name in LISTING or call.name.startswith(("ament_add_", "ament_auto_add_"))


def is_idle(call: EvaluatedCommand) -> bool:
    """Return whether a plain build compiles none of the files that a command names: `install`, EXCLUDE_FROM_ALL."""
    return call.name == "install" or "EXCLUDE_FROM_ALL" in call.texts


def are_sources_known(cmake: CMake) -> bool:
    """Return whether the sources of every target are known."""
    folders = (path_in_package(t.folder.text, t.call.folder) for t in cmake.targets if t.folder is not None)
    words = (word for target in cmake.targets for word in target.sources if not OBJECTS.fullmatch(word.text))
    return cmake.is_complete and all(word.is_known for word in words) and None not in folders


def is_named(cmake: CMake, path: str) -> bool:
    """Return whether a CMake file has the name of a source without its ending, be it in a comment."""
    stem = posixpath.splitext(posixpath.basename(path))[0]
    return any(stem in file.source.text for file in cmake.files)
