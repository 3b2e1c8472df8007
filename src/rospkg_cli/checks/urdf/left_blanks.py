"""Blanks in robots: what an exercise or a template leaves for others to fill in (`<child link="___TODO___"/>`)."""

from __future__ import annotations

from ...languages.xml.parser import Element
from ..python.blank_names import is_blank

STILL = "; it is still to be filled in"


def has_blanks(root: Element) -> bool:
    """Return whether a robot has a blank for a name or a value: it is to be completed."""
    return any(is_blank(value.value) for each in root.walk() for value in each.attributes.values())
