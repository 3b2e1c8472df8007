"""Texts that a variable of C++ is given and nothing reads: no code names it, or it is given another one at once."""

from __future__ import annotations

import re
from collections.abc import Iterable

from ...lazy_regex import regex
from ...source import Span
from ..paths.home_path_texts import without_comments

GIVEN = regex(
    r"\b(?:string|string_view|path|auto|char)[ \t]*(?:const)?[ \t*&]+(\w+)[ \t]*(?:\[\s*\])?"
    r"\s*[={(]\s*(?:std::string\()?\"$"
)
"""A variable of a type that opens no file, which begins with a text."""
LITERAL = regex(r"\"[^\"\n]*\"")
MOST = 200
IN_HEADERS = ("include/",)


def is_unread_text(path: str, text: str, place: Span, others: Iterable[tuple[str, str]]) -> bool:
    """Return whether a place in a text without comments is all that a variable is given, and nothing reads it.

    Args:
        others: the paths and texts of all C++ of the package.
    """
    given = GIVEN.search(text, max(0, place.start - MOST), place.start)
    if given is None or path.startswith(IN_HEADERS):
        return False
    name = re.escape(given[1])
    again = re.match(rf"\"\s*[)}}]*;\s*{name}\s*=(?!=)([^;]*);", text[place.end :])
    if again is not None and not re.search(rf"\b{name}\b", LITERAL.sub("", again[1])):
        return True
    word = re.compile(rf"\b{name}\b")
    texts = [text, *(without_comments(each, other) for each, other in others if each != path and given[1] in other)]
    return sum(len(word.findall(each)) for each in texts) == 1
