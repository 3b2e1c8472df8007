"""Split an interface file into lines and sections, as rosidl_adapter does."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...ros.interfaces import SECTIONS, SEPARATORS
from ...source import Source, Span
from .grammar_problem import GrammarCode, GrammarProblem
from .interface_file import InterfaceFile, MessageSection
from .member_parser import InterfaceLine
from .section_parser import SectionReader

NEARLY = regex(r"[ \t]*-{2,}[ \t]*(?:#.*)?")
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
        SeparatorLine(index, Span(line.at, line.at + len(written)), written == "---")
        for index, (line, written) in enumerate(zip(lines, source.text.splitlines(), strict=True))
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
    for mark in marks:
        if not mark.exact and mark in chosen[:wanted]:
            yield GrammarProblem(mark.span, GrammarCode.SEPARATOR_WITH_BLANKS, (), "---", mark.span)
        elif mark not in chosen[:wanted]:
            yield GrammarProblem(mark.span, GrammarCode.TOO_MANY_SEPARATORS, (kind,))
    if len(chosen) < wanted:
        first = Span(lines[0].at, lines[0].at + len(lines[0].text)) if lines else Span(0, 0)
        yield GrammarProblem(first, GrammarCode.TOO_FEW_SEPARATORS, (kind, str(len(chosen) or "none")))
