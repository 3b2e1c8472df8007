"""Split an interface file into lines and sections, as rosidl_adapter does."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise

from ...light_dataclasses import dataclass
from ...ros.interfaces import SECTIONS, SEPARATORS
from ...source import Source, Span
from .interface_file import GrammarProblem, InterfaceFile, MessageSection
from .section_parser import InterfaceLine, SectionReader

NEARLY = re.compile(r"[ \t]*-{2,}[ \t]*(?:#.*)?")
"""A separator as people write it; rosidl takes only a line that is exactly `---`."""


@dataclass(frozen=True, slots=True)
class SeparatorLine:
    """A line that separates sections, or is intended to."""

    index: int
    span: Span
    exact: bool


def parse_interface(source: Source, kind: str) -> InterfaceFile:
    """Read a text of a kind (`msg`, `srv`, `action`); everything that rosidl refuses becomes a problem."""
    raw = source.text.splitlines(keepends=True)
    lines = list(numbered(raw))
    marks = [
        SeparatorLine(index, Span(line.at, line.at + len(line.text)), raw[index].splitlines()[0] == "---")
        for index, line in enumerate(lines)
        if NEARLY.fullmatch(line.text)
    ]
    exact = [mark for mark in marks if mark.exact]
    chosen = exact if len(exact) == SEPARATORS[kind] else marks
    problems = list(separator_problems(kind, marks, chosen, lines))
    sections = []
    for place, part in enumerate(split(lines, chosen, marks)):
        reader = SectionReader(part)
        problems += reader.problems
        suffix = SECTIONS[kind][place] if place < len(SECTIONS[kind]) else ""
        sections.append(MessageSection(suffix, tuple(reader.members)))
    return InterfaceFile(source, kind, tuple(sections), tuple(sorted(problems, key=lambda p: p.span)))


def numbered(raw: Sequence[str]) -> Iterator[InterfaceLine]:
    at = 0
    for line in raw:
        yield InterfaceLine(line.replace("\t", " ").rstrip(), at)
        at += len(line)


def split(
    lines: Sequence[InterfaceLine], chosen: Sequence[SeparatorLine], marks: Sequence[SeparatorLine]
) -> Iterator[list[InterfaceLine]]:
    cuts = [-1, *(mark.index for mark in chosen), len(lines)]
    skipped = {mark.index for mark in marks}
    for before, after in pairwise(cuts):
        yield [lines[i] for i in range(before + 1, after) if i not in skipped]


def separator_problems(
    kind: str, marks: Sequence[SeparatorLine], chosen: Sequence[SeparatorLine], lines: Sequence[InterfaceLine]
) -> Iterator[GrammarProblem]:
    wanted = SEPARATORS[kind]
    has = {0: "no line `---`", 1: "exactly one line `---`", 2: "exactly two lines `---`"}[wanted]
    for mark in marks:
        if not mark.exact and mark in chosen[:wanted]:
            message = "rosidl takes only a line that is exactly `---` for a separator, without spaces around it"
            yield GrammarProblem(mark.span, f"{message}: the build stops here", "---", mark.span, "write `---`")
        elif mark not in chosen[:wanted]:
            yield GrammarProblem(mark.span, f"a .{kind} file has {has}; this one is too many, and the build stops here")
    if len(chosen) < wanted:
        parts = " and ".join({"srv": ("request", "response"), "action": ("goal", "result", "feedback")}[kind])
        first = Span(lines[0].at, lines[0].at + len(lines[0].text)) if lines else Span(0, 0)
        yield GrammarProblem(first, f"a .{kind} file has {has} between {parts}; here is {len(chosen) or 'none'}")
