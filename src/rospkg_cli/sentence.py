"""One line of bounded length, for messages that quote a user's input, a template or an untrusted file."""

from __future__ import annotations

from .control_characters import visible

LONGEST = 2_000
"""Characters; a longer text loses its middle."""


def single_line(text: str) -> str:
    """Return a text with control characters escaped, and without its middle where it is very long."""
    line = visible(text if len(text) <= LONGEST else text[:LONGEST] + text[-LONGEST:])
    if max(len(text), len(line)) <= LONGEST:
        return line
    return f"{line[: LONGEST * 3 // 4]} … {line[-LONGEST // 4 :]}"
