"""The default value that code gives a parameter, as it is written."""

from __future__ import annotations

from ..lazy_regex import regex

DECLARES = regex(r"declare\w*\s*(?:<[\w:<>, ]*>)?\s*\((?:[^()\"';]|\([^()]*\))*$|[\[(,]\s*\(\s*$")
"""What may stand between the start of a declaration and the name: a list of them in Python is one of tuples."""

NEAR = 300
"""Characters before a name in which its declaration begins."""

MAX_LENGTH = 80
OPENING, CLOSING = "([{<", ")]}>"


def default_behind(text: str, start: int, end: int) -> str:
    """Return the argument that follows a quoted name, whose quotes are around a span, in a declaration; "" for none."""
    if not DECLARES.search(text[max(0, start - NEAR) : start - 1]):
        return ""
    rest = text[end + 1 : end + 1 + NEAR].lstrip()
    if not rest.startswith(","):
        return ""
    depth, quote, value = 0, "", ""
    for letter in rest[1:]:
        if quote:
            quote = "" if letter == quote else quote
        elif letter in "\"'":
            quote = letter
        elif letter in OPENING:
            depth += 1
        elif letter in CLOSING or (letter == "," and not depth):
            if not depth:
                break
            depth -= 1
        value += letter
    else:
        return ""
    value = " ".join(value.split())
    return value if len(value) <= MAX_LENGTH else ""
