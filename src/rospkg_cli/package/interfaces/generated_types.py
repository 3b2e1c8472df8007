"""Names of C++ that look like the types which rosidl generates, found once for all rules that ask for them."""

from __future__ import annotations

from typing import cast

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Source

TYPE_END = regex(r"::(msg|srv|action)::([A-Z]\w*)")


@dataclass(frozen=True, slots=True)
class GeneratedType:
    """`package::kind::name` in a text, also in comments and strings; the package is "" where none stands before it."""

    package: str
    kind: str
    name: str
    start: int
    behind_package: int
    end: int


def generated_types(source: Source) -> list[GeneratedType]:
    """Return what looks like generated types, in the order of the text."""
    known = vars(source)
    if "generated_types" not in known:
        known["generated_types"] = list_types(source.text)
    return cast("list[GeneratedType]", known["generated_types"])


def list_types(text: str) -> list[GeneratedType]:
    found = []
    for match in TYPE_END.finditer(text):
        start = at = match.start()
        while start and (text[start - 1].isalnum() or text[start - 1] == "_"):
            start -= 1
        found.append(GeneratedType(text[start:at], match[1], match[2], start, at, match.end()))
    return found
