"""Parameters that Python code declares and never reads: what a file gives them opens nothing."""

from __future__ import annotations

import re
from collections.abc import Iterable

from ...lazy_regex import regex

DECLARES = regex(r"(?m)^[ \t]*(?:\w+\.)+declare_parameters?[ \t]*\(")
"""A declaration whose value is not used at the beginning of its statement."""
UNKNOWN_READS = regex(
    r"get_parameters|get_parameter(?:_or|_value)?\(\s*(?![\"'])|by_prefix|\b_parameters\b|parameters_callback"
    r"|post_set|pre_set|describe_parameter|list_parameters"
)
"""What may read a parameter by a name that does not stand there."""


def is_idle(name: str, code: Iterable[str]) -> bool:
    """Return whether the one place of a parameter's name in Python code, without comments, only declares it."""
    every = tuple(code)
    texts = [text for text in every if name in text]
    word = re.compile(rf"([\"']){re.escape(name)}\1")
    places = [(text, found.start()) for text in texts for found in word.finditer(text)]
    if len(places) != 1 or any(f".{name}" in text for text in texts):
        return False
    (text, at), *_ = places
    if any(map(UNKNOWN_READS.search, every)):
        return False
    before = list(DECLARES.finditer(text, 0, at))
    end = end_of_call(text, before[-1].end()) if before else -1
    return end > at and text[end : end + 1] != "."


def end_of_call(text: str, start: int) -> int:
    """Return the place behind the bracket that closes a call; the end of the text where none does."""
    depth = 1
    for found in re.finditer(r"[()]", text[start:]):
        depth += 1 if found[0] == "(" else -1
        if not depth:
            return start + found.end()
    return len(text)
