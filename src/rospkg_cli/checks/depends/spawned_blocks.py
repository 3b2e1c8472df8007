"""Which controllers of a parameter file something spawns: controller_manager loads those alone."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise

from ...lazy_regex import regex

MANAGER = "controller_manager"
PARAMETERS = "ros__parameters"
KEY = regex(r"(?P<indent>[ ]*)(?P<name>[\w/]+)[ ]*:[ ]*(?:\#.*)?")


def block_of(text: str, at: int) -> str | None:
    """Return the name of the controller whose type stands at a place; None below anything but controller_manager."""
    names = list(keys_above(text, at))
    return names[0] if names and any(name.strip("/") == MANAGER for name in names[1:]) else None


def is_commented_out(text: str, at: int) -> bool:
    """Return whether a place is in the parameters of a controller whose type stands in a comment alone."""
    names = list(keys_above(text, at))
    node = next((name for key, name in pairwise(names) if key == PARAMETERS), "")
    remark = re.compile(rf"^[ ]*#[ ]*{re.escape(node)}[ ]*:[ ]*\n[ ]*#[ ]*type[ ]*:", re.MULTILINE)
    return bool(node) and remark.search(text) is not None and node not in other_types(text, "")


def keys_above(text: str, at: int) -> Iterator[str]:
    """Yield the keys around a place of a YAML text in block style, innermost first."""
    start = text.rfind("\n", 0, at) + 1
    depth = len(text[start:at]) - len(text[start:at].lstrip())
    for line in reversed(text[:start].splitlines()):
        key = KEY.fullmatch(line)
        if key and len(key["indent"]) < depth:
            depth = len(key["indent"])
            yield key["name"]


def other_types(text: str, own: str) -> list[str]:
    """Return the names of the other controllers of a text that have a type."""
    places = [match.start() for match in re.finditer(r"^[ ]+type[ ]*:", text, re.MULTILINE)]
    found = [block_of(text, text.index("type", place)) for place in places]
    return [name for name in found if name and name != own]
