"""Folders of headers that every branch of an `#if … #else … #endif` includes: one of them is always included."""

from __future__ import annotations

from collections.abc import Collection

from ...lazy_regex import regex
from ...light_dataclasses import dataclass, field
from .lexer import guards

DIRECTIVE = regex(r"(?m)^[ \t]*#[ \t]*(if|ifdef|ifndef|elif|else|endif|include)\b[ \t]*(?:[<\"]([\w.-]+)/)?")


@dataclass(slots=True)
class Branches:
    """One open `#if`, with the folders that each of its branches includes."""

    is_guard: bool = False
    """Whether it is the include guard of a header, or the file itself: then all in it counts."""
    all: list[set[str]] = field(default_factory=lambda: [set()])
    has_else: bool = False


def common_includes(text: str, included: Collection[int]) -> frozenset[str]:
    """Return the first folders of headers that are included whatever the conditions are.

    `included` holds the offsets behind the bracket or quote of the includes that count: others may be in comments.
    """
    levels = [Branches(is_guard=True)]
    is_first = True
    for match in DIRECTIVE.finditer(text):
        word, folder = match[1], match[2]
        if word.startswith("if"):
            end = text.find("\n", match.end())
            is_guard = is_first and word == "ifndef" and guards(text, match.end(), end if end >= 0 else len(text))
            levels.append(Branches(is_guard))
        elif word == "include":
            if folder and match.start(2) in included:
                levels[-1].all[-1].add(folder)
        elif word == "endif":
            close(levels)
        else:
            levels[-1].all.append(set())
            levels[-1].has_else |= word == "else"
        is_first = False
    return frozenset(levels[0].all[0])


def close(levels: list[Branches]) -> None:
    """End the innermost `#if`: what is in all of its branches is in the one around it."""
    if len(levels) > 1:
        ended = levels.pop()
        if ended.is_guard or ended.has_else:
            levels[-1].all[-1] |= set.intersection(*ended.all)
