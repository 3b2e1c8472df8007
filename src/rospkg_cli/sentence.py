"""One line of bounded length, for messages that quote what a user, a template or a stranger's file said."""

from __future__ import annotations

from .control_characters import visible

LONGEST = 2_000
"""Characters; what was given is quoted whole up to here."""


def single_line(text: str) -> str:
    """Return a text with escapes for what is not seen, and without the middle where it is very long."""
    line = visible(text if len(text) <= LONGEST else text[:LONGEST] + text[-LONGEST:])
    if max(len(text), len(line)) <= LONGEST:
        return line
    return f"{line[: LONGEST * 3 // 4]} … {line[-LONGEST // 4 :]}"
