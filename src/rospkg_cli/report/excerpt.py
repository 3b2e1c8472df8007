"""The line of source that a finding is about, with carets below the spot."""

from __future__ import annotations

from ..control_characters import visible_lines
from ..finding import Finding
from .color import SEVERITY_COLORS, paint

MOST = 110
"""Characters of a line that are shown where nothing limits the width."""

GUTTER = 8
"""Columns of the line number and the bar behind it."""

BEFORE = 20
"""Characters that are shown before the spot in a line that is cut."""


def excerpt(finding: Finding, width: int | None, color: bool) -> list[str]:
    """Return the source line with a number, and a line of carets below it; nothing for a file without text."""
    line = finding.excerpt.removesuffix("\r")
    if not line.strip():
        return []
    place, drawn = finding.location, as_drawn(line)
    most = MOST if width is None else max(min(width - GUTTER, MOST), BEFORE)
    start = len(as_drawn(line[: place.column - 1]))
    end = place.end_column - 1 if place.end_line == place.line else len(line.rstrip())
    length = max(1, len(as_drawn(line[:end])) - start)
    before = min(BEFORE, most // 2)
    skipped = max(0, min(start - before, len(drawn) - most)) if len(drawn) > most else 0
    shown = drawn[skipped : skipped + most].rstrip()
    start -= skipped
    marks = "^" * max(1, min(length, len(shown) - start))
    return [
        paint(f"{place.line:>5} | ", "dim", color) + shown,
        paint(f"{'':>5} | ", "dim", color) + " " * start + paint(marks, SEVERITY_COLORS[finding.severity], color),
    ]


def as_drawn(line: str) -> str:
    """Return a line of source as it is shown: what a terminal would obey is seen, tabs are blanks."""
    return visible_lines(line).expandtabs(4)
