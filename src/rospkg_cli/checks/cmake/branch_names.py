"""What the branches around each command ask for, as far as it must hold for the command to run."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from ...languages.cmake.command_blocks import Block, Branch
from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cmake.file import ROOT
from ...languages.cmake.syntax import CommandInvocation
from ...package.cmake.cmake_project import CMake

EITHER = frozenset({"OR", "(", ")"})
"""Words of a condition by which no part of it must hold."""
PAIR = 2
"""As many branches have `if` and `else`, and as many words has `NOT A`."""
AskedBy = Callable[[Sequence[str]], Iterable[str]]
"""The names that the words of a condition ask for."""


def names_around(cmake: CMake, asked_by: AskedBy) -> dict[int, tuple[str, ...]]:
    """Return, by the identity of each command, the names that its branches ask for, the outermost first.

    What a file asks for that one command alone reads is asked for by all in it.
    """
    found: dict[int, tuple[str, ...]] = {}
    readers = {path: calls[0] for path, calls in reading_calls(cmake).items() if len(calls) == 1}
    for file in sorted(cmake.files, key=lambda file: depth_of(file.path, readers)):
        reader = readers.get(file.path)
        around = found.get(id(reader.command), ()) if reader is not None else ()
        waiting: list[tuple[CommandInvocation | Block, tuple[str, ...]]] = [(each, around) for each in file.body]
        while waiting:
            each, names = waiting.pop()
            if isinstance(each, CommandInvocation):
                found[id(each)] = names
                continue
            for branch, texts in conditions_of(each):
                inner = (*names, *asked_by(texts))
                waiting += [(below, inner) for below in branch.body]
    return found


def reading_calls(cmake: CMake) -> dict[str, list[EvaluatedCommand]]:
    """Return, by the path of each file, the commands that read it."""
    paths, found = {file.path for file in cmake.files}, dict[str, list[EvaluatedCommand]]()
    for call in cmake.named("add_subdirectory", "include"):
        read = path_in_package(call.texts[0], call.folder) if call.texts else None
        path = posixpath.join(read, ROOT) if read is not None and call.name == "add_subdirectory" else read
        if path in paths and path is not None:
            found.setdefault(path, []).append(call)
    return found


def depth_of(path: str, readers: Mapping[str, EvaluatedCommand]) -> int:
    """Return how many files lead to one; a file that reads itself is as deep as there are files."""
    depth = 0
    while path in readers and depth <= len(readers):
        path, depth = readers[path].path, depth + 1
    return depth


def conditions_of(block: Block) -> Iterator[tuple[Branch, list[str]]]:
    """Yield each branch of a block with the words that must hold in it: `else` behind `if(NOT A)` alone asks for A."""
    for branch in block.branches:
        texts = condition_of(branch)
        first = condition_of(block.branches[0])
        if branch.command.name == "else" and len(block.branches) == PAIR and len(first) == PAIR and first[0] == "NOT":
            texts = first[1:]
        yield branch, texts


def condition_of(branch: Branch) -> list[str]:
    """Return the words of a condition of which each part must hold; none for any other."""
    texts = [each.text for each in branch.command.arguments]
    return texts if branch.command.name in ("if", "elseif") and EITHER.isdisjoint(texts) else []
