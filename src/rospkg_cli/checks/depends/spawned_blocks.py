"""Which controllers of a parameter file something spawns: controller_manager loads those alone."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...lazy_regex import regex

MANAGER = "controller_manager"
KEY = regex(r"(?P<indent>[ ]*)(?P<name>[\w/]+)[ ]*:[ ]*(?:\#.*)?")


def block_of(text: str, at: int) -> str | None:
    """Return the name of the controller whose type stands at a place; None below anything but controller_manager."""
    names = list(keys_above(text, at))
    return names[0] if names and any(name.strip("/") == MANAGER for name in names[1:]) else None


def keys_above(text: str, at: int) -> Iterator[str]:
    """Yield the keys around a place of a YAML text in block style, innermost first."""
    start = text.rfind("\n", 0, at) + 1
    depth = len(text[start:at]) - len(text[start:at].lstrip())
    for line in reversed(text[:start].splitlines()):
        key = KEY.fullmatch(line)
        if key and len(key["indent"]) < depth:
            depth = len(key["indent"])
            yield key["name"]


def types_beside(text: str, own: str) -> list[str]:
    """Return the names of the other controllers of a text that have a type."""
    places = [match.start() for match in re.finditer(r"^[ ]+type[ ]*:", text, re.MULTILINE)]
    found = [block_of(text, text.index("type", place)) for place in places]
    return [name for name in found if name and name != own]
