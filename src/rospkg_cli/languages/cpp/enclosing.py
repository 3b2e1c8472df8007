"""The functions of C++ around a place, by the text before their braces."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...lazy_regex import regex
from .code_text import code_text
from .unconditional import unconditional

BRACE = regex(r"[{}]")
END = regex(r"[;{}]")
NAME = regex(r"([A-Za-z_]\w*)\s*\(")
OTHERS = regex(r"main|on_?[iI]nit\w*|on_?[cC]onfigure\w*|configure|init(?:ialize)?")
"""What a framework calls, or whoever makes a plugin."""
OVERRIDES = regex(r"\b(?:override|final|virtual)\b")
CLASS = regex(r"\b(?:class|struct)\s+(?:[A-Z_]+\s+)?(\w+)[^()]*$|^[^()]*?\b(\w+)(?:\s*<[^<>]*>)?\s*::\s*~?\w+\s*\(")
"""A class, or a function that is defined outside of it."""
CALL = regex(r"(?:->|[;{}).=(,]|\breturn)\s*$")
"""What stands before a call, where a declaration has a type."""
KEYWORDS = frozenset({"if", "for", "while", "switch", "catch"})


def openings(code: str, at: int) -> Iterator[str]:
    """Yield what stands before each brace that is open at a place, the outermost first; no literals are in the code."""
    opened: list[int] = []
    for found in BRACE.finditer(code, 0, at):
        if found[0] == "{":
            opened.append(found.start())
        elif opened:
            opened.pop()
    for brace in opened:
        start = max((each.end() for each in END.finditer(code, max(0, brace - 1000), brace)), default=0)
        yield code[start:brace]


def heads(code: str, at: int) -> Iterator[str]:
    """Yield what stands before each brace that is open at a place, from the outermost function on."""
    for opening in openings(code, at):
        name = NAME.search(opening)
        if name is not None and name[1] not in KEYWORDS:
            yield opening


def class_around(code: str, at: int) -> str:
    """Return the class whose body, or whose function, is around a place; "" where there is none."""
    names = [found[1] or found[2] for each in openings(code, at) if (found := CLASS.search(each))]
    return names[-1] if names else ""


def always_called(text: str, at: int) -> bool:
    """Return whether the function around a place is a constructor or one that others call, or its file calls it, and
    not only under a condition.
    """
    code = code_text(text)
    head = next(heads(code, at), "")
    found = NAME.search(head)
    if found is None or OTHERS.fullmatch(found[1]) or OVERRIDES.search(head):
        return True
    if head[: found.start()].strip() in ("", "explicit"):
        return True  # a constructor, which has no type
    name = found[1]
    if re.search(rf"\b(?:class|struct)\s+{name}\b|\b{name}\s*::\s*{name}\s*\(", code):
        return True
    found_calls = (each.start() for each in re.finditer(rf"(?<![\w~:]){name}\s*\(", code))
    return bool(unconditional(text, (each for each in found_calls if CALL.search(code, max(0, each - 60), each))))
