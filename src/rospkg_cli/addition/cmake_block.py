"""Commands that are put into CMakeLists.txt as a block of their own, and found there again."""

from __future__ import annotations

from collections.abc import Iterator

from ..edits.cmake_commands import match_case, remove_argument, start_with_comments
from ..finding import Edit
from ..languages.cmake.command_blocks import Block
from ..languages.cmake.file import CMakeFile
from ..languages.cmake.syntax import CommandInvocation
from ..source import Span

FIRST = ("find_package", "ament_auto_find_build_dependencies", "autoware_package", "project", "include")
"""Commands that a target comes after."""


def put_before_installs(file: CMakeFile, lines: str) -> tuple[Edit, ...]:
    """Put a block before the first rule that installs, below all packages that are looked for; else before the end.

    Nothing where the file has neither: then it is no package.
    """
    anchor = anchor_of(file)
    if anchor is None:
        return ()
    at = start_with_comments(file.source, anchor)
    return (Edit(file.path, Span(at, at), f"{match_case(file, lines)}\n\n"),)


def anchor_of(file: CMakeFile) -> CommandInvocation | None:
    """Return the command that a target is put before."""
    behind = max((i for i, each in enumerate(file.body) if command_of(each).name in FIRST), default=-1)
    for each in file.body[behind + 1 :]:
        command = command_of(each)
        if command.name == "install" or command is file.end:
            return command
    return file.end


def command_of(part: CommandInvocation | Block) -> CommandInvocation:
    return part.command if isinstance(part, Block) else part


def block_removals(file: CMakeFile, lines: str) -> Iterator[tuple[Edit, ...]]:
    """Yield the ways to take out a block that is there as it was written: with the blank line behind or before it."""
    text, block = file.source.text, match_case(file, lines)
    at = text.rfind(block)
    while at >= 0 and at and text[at - 1] != "\n":
        at = text.rfind(block, 0, at)
    if at < 0:
        return
    end = at + len(block)
    if text.startswith("\n\n", end):
        yield (Edit(file.path, Span(at, end + 2), ""),)
    if text.endswith("\n\n", 0, at):
        yield (Edit(file.path, Span(at - 2, end), ""),)
    yield (Edit(file.path, Span(at, min(end + 1, len(text))), ""),)


def argument_removals(file: CMakeFile, span: Span) -> Iterator[tuple[Edit, ...]]:
    """Yield the ways to take out an argument: with its line, or with the blanks before it, behind it, or above it."""
    text = file.source.text
    yield (remove_argument(file, span),)
    behind = len(text[span.end :]) - len(text[span.end :].lstrip())
    yield (Edit(file.path, Span(span.start, span.end + behind), ""),)
    yield (Edit(file.path, Span(len(text[: span.start].rstrip()), span.end), ""),)
