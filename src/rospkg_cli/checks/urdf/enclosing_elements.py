"""The elements around a place of a robot description, and the conditions of xacro among them."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.xml.parser import Element
from ...source import Span

CONDITIONS = ("xacro:if", "xacro:unless")


def ancestors(root: Element, place: Span) -> Iterator[Element]:
    """Yield the elements around a place, the outermost first; the attributes of a condition are outside of it."""
    waiting = [root]
    while waiting:
        for child in waiting.pop().children:
            if child.span.contains(place):
                if child.tag not in CONDITIONS or place.start >= child.inner.start:
                    yield child
                waiting = [child]
                break
