"""A path that a launch file joins of parts, some of which are known."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Span
from .text import Literal, Substitution

END = regex(r"[\s'\",;:|&()`]")
"""What ends a path inside of a longer text."""
OPEN = "…"
"""Stands in a path for a part that only the launch knows."""


@dataclass(frozen=True, slots=True)
class JoinedPath:
    """A path as it is written behind its base."""

    text: str
    span: Span
    by_default: bool = False
    """Whether the default of an argument is a part of it."""


def literal_of(parts: Sequence[Literal | Substitution], defaults: Mapping[str, str]) -> JoinedPath | None:
    """Return the path that some parts begin with, and its span; `…` is for what is unknown in it."""
    found, spans, by_default = "", [], False
    for part in parts:
        text = part.text if isinstance(part, Literal) else default_of(part, defaults)
        if text is None:
            found += OPEN
            spans.append(part.span)
            continue
        by_default |= isinstance(part, Substitution)
        end = END.search(text)
        piece = text[: end.start()] if end else text
        found += piece
        as_written = part.span.end - part.span.start == len(text)
        spans.append(Span(part.span.start, part.span.start + len(piece)) if as_written else part.span)
        if end:
            break
    if not spans:
        return None
    wide = Span(spans[0].start, spans[-1].end)
    in_order = all(a.end <= b.start or a == b for a, b in pairwise(spans))
    return JoinedPath(found, wide if in_order and wide.start <= wide.end else spans[-1], by_default)


def default_of(part: Substitution, defaults: Mapping[str, str]) -> str | None:
    """Return the default of the argument that a substitution is replaced by."""
    name = part.arguments[0].literal if part.name == "var" and len(part.arguments) == 1 else None
    return defaults.get(name) if name else None
