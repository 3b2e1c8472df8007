"""Where the spans of a text are after an edit: their text is the same there, and nothing of an edited line is kept."""

from __future__ import annotations

import pytest

from rospkg_cli.cli.server.kept_spans import KeptSpans
from rospkg_cli.finding import Location
from rospkg_cli.source import Source, Span

TEXTS = [
    "",
    "\n",
    "a\nb\nc",
    "a\nb\nc\n",
    "a\nX\nb\nc\n",
    "a\nc\n",
    "b\nc",
    "a\nb\nY",
    "a\na\na\n",
    "a\na\n",
    "Z\na\nb\nc\n",
]


@pytest.mark.parametrize("before", TEXTS)
def test_a_span_that_is_kept_has_the_same_text(before: str) -> None:
    for now in TEXTS:
        kept = KeptSpans.between(before, now)
        for start in range(len(before) + 1):
            for end in range(start, len(before) + 1):
                span = kept.span(Span(start, end))
                assert span is None or now[span.start : span.end] == before[start:end]


@pytest.mark.parametrize(
    "before, now, lost",
    [
        ("a\nb\nc\n", "a\nB\nc\n", {2, 3}),
        ("a\nb\nc\n", "a\nnew\nb\nc\n", set()),
        ("a\nb\nc\n", "a\nc\n", {2, 3}),
        ("a\nb", "a\nb\nnew", set()),
        ("a\nb", "A\nb", {0, 1}),
        ("a\nb\n", "a\nb\n", set()),
    ],
)
def test_what_is_lost_is_in_the_lines_that_differ(before: str, now: str, lost: set[int]) -> None:
    kept = KeptSpans.between(before, now)
    letters = {at for at in range(len(before)) if kept.span(Span(at, at + 1)) is None}
    assert letters == lost


def test_a_place_moves_with_its_lines() -> None:
    source, kept = Source("a", "a\nb\nc d\n"), KeptSpans.between("a\nb\nc d\n", "a\nc d\n")
    first, last = Location("a", Span(0, 1), 1, 1, 1, 2), Location("a", Span(6, 7), 3, 3, 3, 4)
    assert source.position(6) == (3, 3)
    assert kept.location(first) == first
    assert kept.location(last) == Location("a", Span(4, 5), 2, 3, 2, 4)
    assert kept.location(Location("a", Span(2, 3), 2, 1, 2, 2)) is None
