"""Executables that one rule installs into a wrong place: how bad that is, and what sends them to the right one."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ..checks.cmake.misplaced_executables import MisplacedExecutable
from ..finding import Edit, Severity
from ..package.cmake.cmake_project import CMake
from .cmake_destination import to_libexec

OF_FILES = ("DIRECTORY", "FILES")
"""Kinds of rules that install no programs."""


def together(
    cmake: CMake, wrong: Iterable[MisplacedExecutable]
) -> Iterator[tuple[tuple[Edit, ...], list[MisplacedExecutable]]]:
    """Yield what one rule installs and the same edits send to its place: that is one cause."""
    found: dict[object, tuple[tuple[Edit, ...], list[MisplacedExecutable]]] = {}
    for each in wrong:
        edits = to_libexec(cmake, each)
        key = (id(each.rule), edits, level(each))
        found.setdefault(key, (edits, []))[1].append(each)
    yield from found.values()


def level(misplaced: MisplacedExecutable) -> Severity | None:
    if misplaced.rule.kind in OF_FILES:
        return None if misplaced.is_started else Severity.INFO
    if misplaced.is_started:
        return None
    if not misplaced.is_node or misplaced.is_tool:
        return Severity.INFO
    is_quiet = misplaced.destination == "bin" or misplaced.rule.kind == "PROGRAMS"
    return Severity.WARNING if is_quiet else None
