"""Find the ignore comments of a package: `# rospkg: ignore[SET101] reason`, in whatever comment a file has."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from pathlib import PurePosixPath

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Source, Span
from ...unreadable import UnreadableError
from .file_head import FileHead

COMMENT = regex(
    r"(?P<open>#|//|<!--)[ \t]*rospkg:[ \t]*(?P<kind>ignore(?:-file)?)"
    r"(?:\[(?P<codes>[^\]\n]{0,1000})\]|(?![\w\[-]))(?P<reason>[^\n]*)"
)
MAX_REASON = 4_000
"""A comment of XML may go on for so many characters."""
NAME = regex(r"[^\s,]+")
KINDS = "py xml cfg txt cmake yaml yml launch urdf xacro sdf world msg srv action c cc cpp cxx h hh hpp hxx"
SUFFIXES = frozenset(f".{kind}" for kind in KINDS.split())


@dataclass(frozen=True, slots=True)
class Suppression:
    """One ignore comment; its path is relative to the root of the run."""

    path: str
    lines: tuple[int, ...]
    """The lines whose findings it ignores; empty for the whole file."""
    codes: tuple[str, ...]
    code_spans: tuple[Span, ...]
    reason: str
    span: Span
    """The whole comment."""
    line_span: Span
    """The comment with the blanks before it, and its whole line where it is alone there."""


def suppressions_in(files: PackageFiles) -> Iterator[Suppression]:
    """Yield the ignore comments of every file that a rule may report on."""
    for path in files.paths:
        name = path.rpartition("/")[2]
        if name[max(name.rfind("."), 0) :] not in SUFFIXES or name in SUFFIXES or not files.holds(path, b"rospkg:"):
            continue
        try:
            source = files.source(path)
        except UnreadableError:
            continue
        yield from in_source(source, str(PurePosixPath(files.folder, path)))


def in_source(source: Source, path: str) -> Iterator[Suppression]:
    real = python_comments(source) if path.endswith(".py") else None
    head = FileHead(source)
    for match in COMMENT.finditer(source.text):
        line = source.position(match.start())[0]
        if real is not None and line not in real:
            continue
        span, reason = extent(source, match)
        whole = source.line_span(line)
        alone = not (source.text[whole.start : span.start] + source.text[span.end : whole.end]).strip()
        lines: tuple[int, ...] = (line, line + 1) if alone else (line,)
        if match.group("kind") == "ignore-file" and head.holds(match.start()):
            lines = ()
        names = list(NAME.finditer(source.text, *match.span("codes"))) if match["codes"] else []
        yield Suppression(
            path,
            lines,
            codes=tuple(name.group() for name in names),
            code_spans=tuple(Span(*name.span()) for name in names),
            reason=reason,
            span=span,
            line_span=removal(source, span, alone),
        )


def extent(source: Source, match: re.Match[str]) -> tuple[Span, str]:
    """Return the span of the whole comment, and its reason."""
    start = match.start("reason")
    if match.group("open") != "<!--":
        return Span(*match.span()), match.group("reason").strip()
    end = source.text.find("-->", start, start + MAX_REASON)
    if end < 0:
        return Span(*match.span()), match.group("reason").strip()
    return Span(match.start(), end + 3), source.text[start:end].strip()


def removal(source: Source, span: Span, alone: bool) -> Span:
    text = source.text
    start, end = span.start, span.end
    while start and text[start - 1] in " \t":
        start -= 1
    if alone and text[end : end + 1] == "\n":
        return Span(start, end + 1)
    return Span(start, end)


def python_comments(source: Source) -> set[int] | None:
    """Return the lines that hold a real comment, or None where the file can't be tokenised."""
    import tokenize  # few files have an ignore, and it takes a start some milliseconds

    try:
        tokens = tokenize.generate_tokens(io.StringIO(source.text).readline)
        return {token.start[0] for token in tokens if token.type == tokenize.COMMENT}
    except (tokenize.TokenError, SyntaxError):
        return None
