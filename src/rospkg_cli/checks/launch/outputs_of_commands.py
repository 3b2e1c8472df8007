"""Paths in launch files that a command gets to write there: `xacro … -o robot.urdf`, `map_saver_cli -f map`."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from ...lazy_regex import regex
from ...source import Source, Span

LONGEST = 240
"""How many characters before a path may say what is done with it."""
GAP = r"(?:\s|[,+=\[({]|(?:\b[fFrR])?[\"']|\$\([\w-]+(?:\s[^()]*)?\))*"
"""What stands between an option and its value: the end of a text, a comma, the share directory, another start."""
BEFORE = tuple(
    regex(f"{each}{GAP}$")
    for each in (
        r"(?<![\w-])(?:-o|-O|--?(?:out|output|save|record|dump|export)(?:[_-](?!conf)[\w-]*)?)(?![\w-])",
        r"\bmap_saver(?:_cli|_server)?\b[^()]{0,160}(?<![\w-])-f(?![\w-])",
        r"(?<![\w./-])(?:mkdir|tee|touch|mktemp)(?![\w.-])(?:[\"'\s,]+-\w+)*",
        r"[\"'][^\"'\n<]* >>?|[\"']>>?[\"']",
        r"&gt;",
        r"\bstdout\s*=\s*open\(",
        r"\b(?:makedirs|mkdir|copy(?:2|file|tree)?\([^()]{1,160}(?:\([^()]*\)[^()]*)?,)\(?",
    )
)
BOUND = regex(r"(?m)^[ \t]*(\w+)[ \t]*(?::[^=\n]+)?=[ \t]*$")


def is_written(source: Source, spans: Iterable[Span]) -> bool:
    """Return whether one of the places that name a file gives it to a command that writes it."""
    text = source.text
    starts = (start for span in spans for start in uses_of(text, span))
    befores = (text[max(0, start - LONGEST) : start] for start in starts)
    return any(each.search(before) for before in befores for each in BEFORE)


def uses_of(text: str, span: Span) -> Iterator[int]:
    """Yield where a path stands, and where the variable does that it is put into."""
    yield span.start
    bound = BOUND.search(text[max(0, span.start - LONGEST) : span.start])
    if bound is not None:
        yield from (each.start() for each in re.finditer(rf"(?<![\w.]){re.escape(bound[1])}\b", text))
