"""What the branches around each command ask for, as far as it must hold for the command to run."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from ...languages.cmake.command_blocks import Block, Branch
from ...languages.cmake.syntax import CommandInvocation
from ...package.cmake.cmake_project import CMake

EITHER = frozenset({"OR", "(", ")"})
"""Words of a condition by which no part of it must hold."""
AskedBy = Callable[[Sequence[str]], Iterable[str]]
"""The names that the words of a condition ask for."""


def names_around(cmake: CMake, asked_by: AskedBy) -> dict[int, tuple[str, ...]]:
    """Return, by the identity of each command, the names that its branches ask for, the outermost first."""
    found: dict[int, tuple[str, ...]] = {}
    waiting: list[tuple[CommandInvocation | Block, tuple[str, ...]]]
    waiting = [(each, ()) for file in cmake.files for each in file.body]
    while waiting:
        each, names = waiting.pop()
        if isinstance(each, CommandInvocation):
            found[id(each)] = names
            continue
        for branch in each.branches:
            inner = (*names, *asked_by(condition_of(branch)))
            waiting += [(below, inner) for below in branch.body]
    return found


def condition_of(branch: Branch) -> list[str]:
    """Return the words of a condition of which each part must hold; none for any other."""
    texts = [each.text for each in branch.command.arguments]
    return texts if branch.command.name in ("if", "elseif") and EITHER.isdisjoint(texts) else []
