"""Defaults of xacro that no robot of a package comes to need, with the values that its arguments have or are given."""

from __future__ import annotations

import re

from ...languages.xml.parser import Element
from ...source import Span
from .ways_into_robots import WaysIntoRobots
from .xacro_calls import ancestors

READ_OFF = "; xacro reads `$(arg {})` only where another argument asks for it"
READS = r"\barg\s+{0}\b|\barg\(\s*[\"']{0}[\"']"


def why_unread(ways: WaysIntoRobots, path: str, root: Element, place: Span) -> str:
    """Return why xacro needs no default that a place is in, as the end of a sentence; "" where it may, or is in none.

    A path that only stands there stops nothing: what reads it does.
    """
    around = [each for each in ancestors(root, place) if each.tag in ("xacro:arg", "xacro:property")]
    if not around or (why := ways.why_unmet(path, root, place)):
        return why if around else ""
    names = [each.get("name") or "" for each in around if each.tag == "xacro:arg"]
    return next((READ_OFF.format(each) for each in names if is_read_off(ways, each)), "")


def is_read_off(ways: WaysIntoRobots, argument: str) -> bool:
    """Return whether robots read an argument, and none comes to a place that does."""
    read = re.compile(READS.format(re.escape(argument)))
    documents = [each for each in ways.reached.library.documents.values() if each is not None]
    places = [(each, Span(*found.span())) for each in documents for found in read.finditer(each.source.text)]
    return bool(places) and all(ways.why_unmet(each.source.path, each.root, place) for each, place in places)
