"""Edits of CMake files: add and remove commands and arguments, in the style of the file."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import groupby

from ..finding import Edit
from ..languages.cmake.file import CMakeFile
from ..languages.cmake.syntax import CommandInvocation
from ..source import Source, Span

MAX_RUN = 200
"""So many neighbouring commands are put into one block: each of their findings carries the whole text."""


def add_at_end(file: CMakeFile, lines: str) -> Edit:
    """Put commands at the end of a file, a blank line before them."""
    text = file.source.text
    end = len(text.rstrip())
    return Edit(file.path, Span(end, len(text)), f"\n\n{match_case(file, lines)}\n" if end else f"{lines}\n")


def add_before(file: CMakeFile, command: CommandInvocation, lines: str) -> Edit:
    """Put commands before another one, above the comment that belongs to it."""
    at = start_with_comments(file.source, command)
    return Edit(file.path, Span(at, at), f"{match_case(file, lines)}\n")


def add_block_before(file: CMakeFile, command: CommandInvocation, lines: str) -> Edit:
    """Put commands before another one, a blank line on either side."""
    edit = add_before(file, command, f"{lines}\n")
    above = file.source.text[: edit.span.start].rstrip(" \t")
    return edit if not above or above.endswith("\n\n") else Edit(edit.path, edit.span, f"\n{edit.text}")


def quoted_like(file: CMakeFile, item: str, other: Span) -> str:
    """Return an argument in quotes where another one has them."""
    return f'"{item}"' if file.source.text.startswith('"', other.start) else item


def add_after(file: CMakeFile, command: CommandInvocation, lines: str) -> Edit:
    """Put commands below another one, behind a comment in its last line."""
    source = file.source
    line = source.line_span(source.position(command.span.end)[0])
    behind = source.text[command.span.end : line.end]
    at = line.end if not behind.strip() or behind.lstrip().startswith("#") else command.span.end
    return Edit(file.path, Span(at, at), f"\n{match_case(file, lines)}")


def remove(file: CMakeFile, command: CommandInvocation) -> Edit:
    """Remove a command, with its line where that holds nothing else."""
    source = file.source
    start = source.line_span(source.position(command.span.start)[0]).start
    end = source.line_span(source.position(command.span.end)[0]).end
    alone = not (source.text[start : command.span.start] + source.text[command.span.end : end]).strip()
    if alone:
        return Edit(file.path, Span(start, min(end + 1, len(source.text))), "")
    return Edit(file.path, command.span, "")


def add_argument(file: CMakeFile, command: CommandInvocation, text: str, after: Span | None = None) -> Edit:
    """Put an argument into a command: below the one before it where that has its own line, else behind it."""
    source = file.source
    last = after or (
        command.arguments[-1].span if command.arguments else Span(command.inner.start, command.inner.start)
    )
    line = source.line_span(source.position(last.start)[0])
    before = source.text[line.start : last.start]
    own_line = not before.strip() and last.end > last.start
    glue = f"\n{before}" if own_line else " " if last.end > last.start else ""
    return Edit(file.path, Span(last.end, last.end), glue + text)


def guard(file: CMakeFile, commands: Sequence[CommandInvocation]) -> dict[int, tuple[Edit, ...]]:
    """Return, by the id of each command, the edit that puts it and its neighbours among them into `if(BUILD_TESTING)`.

    There is no edit where their lines hold something else, nor for a run that only a generator writes.
    """
    wanted = {id(each) for each in commands}
    if not all(has_own_lines(file.source, each) for each in file.top if id(each) in wanted):
        return {}
    found: dict[int, tuple[Edit, ...]] = {}
    for inside, run in groupby(file.body, lambda each: isinstance(each, CommandInvocation) and id(each) in wanted):
        members = [each for each in run if isinstance(each, CommandInvocation)] if inside else []
        if 0 < len(members) <= MAX_RUN:
            found |= dict.fromkeys(map(id, members), (guard_commands(file, members[0], members[-1]),))
    return found


def guard_commands(file: CMakeFile, first: CommandInvocation, last: CommandInvocation) -> Edit:
    """Put the lines from one command to another into `if(BUILD_TESTING)`."""
    start = file.source.line_span(file.source.position(first.span.start)[0]).start
    end = file.source.line_span(file.source.position(last.span.end)[0]).end
    lines = file.source.text[start:end].split("\n")
    inside = "\n".join(f"{file.indent}{line}" if line.strip() else line for line in lines)
    names = match_case(file, "if(BUILD_TESTING)\nendif()").split("\n")
    return Edit(file.path, Span(start, end), f"{names[0]}\n{inside}\n{names[1]}")


def has_own_lines(source: Source, command: CommandInvocation) -> bool:
    """Return whether the lines of a command hold nothing else but a comment."""
    start = source.line_span(source.position(command.span.start)[0]).start
    end = source.line_span(source.position(command.span.end)[0]).end
    behind = source.text[command.span.end : end].strip()
    return not source.text[start : command.span.start].strip() and (not behind or behind.startswith("#"))


def match_case(file: CMakeFile, lines: str) -> str:
    """Return commands with their names in the case that the file has."""
    if not file.is_upper:
        return lines
    return re.sub(r"^([ \t]*)([a-z_]\w*)(?=\()", lambda match: match[1] + match[2].upper(), lines, flags=re.MULTILINE)


def margin(file: CMakeFile, command: CommandInvocation) -> str:
    """Return the blanks at the beginning of the line of a command."""
    line = file.source.slice(file.source.line_span(file.source.position(command.span.start)[0]))
    return line[: len(line) - len(line.lstrip())]


def start_with_comments(source: Source, command: CommandInvocation) -> int:
    """Return where a command begins, with the comment lines right above it."""
    at = source.line_span(source.position(command.span.start)[0]).start
    while at:
        line = source.line_span(source.position(at - 1)[0])
        if not source.slice(line).lstrip().startswith("#"):
            break
        at = line.start
    return at


def literal_span(source: Source, span: Span, text: str) -> Span | None:
    """Return the span of a text that an argument holds literally, without quotes; None where it is evaluated."""
    written = source.slice(span)
    if written == text:
        return span
    return Span(span.start + 1, span.end - 1) if written == f'"{text}"' else None


def listed(words: Sequence[str], indent: str) -> str:
    return "".join(f"\n{indent}{word}" for word in words)


def remove_argument(file: CMakeFile, span: Span) -> Edit:
    """Remove an argument, with its line where that holds nothing else, else with the blanks before it."""
    source = file.source
    start = source.line_span(source.position(span.start)[0]).start
    end = source.line_span(source.position(span.end)[0]).end
    if not (source.text[start : span.start] + source.text[span.end : end]).strip():
        return Edit(file.path, Span(start, min(end + 1, len(source.text))), "")
    before = len(source.text[: span.start].rstrip(" \t"))
    return Edit(file.path, Span(before, span.end), "")
