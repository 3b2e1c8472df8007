"""Defaults of xacro that no robot of a package uses, for the values that its arguments have or are given."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...languages.xml.parser import Document, Element
from ...package.urdf.robot_words import given_in, words_of
from ...source import Span
from .enclosing_elements import ancestors
from .given_to_viewers import SPAWNERS
from .opening_texts import LAUNCH
from .ways_into_robots import WaysIntoRobots

READ_OFF = "; xacro reads `$(arg {})` only where another argument asks for it"
FOR_GAZEBO = "; Gazebo alone reads `$(arg {0})`, and what spawns the robot here gives it"
READS = r"\barg\s+{0}\b|\barg\(\s*[\"']{0}[\"']"


def why_unread(ways: WaysIntoRobots, path: str, root: Element, place: Span) -> str:
    """Return why xacro never uses the default that a place is in, as the end of a sentence; "" where it may.

    A path in a default does no harm by itself, only where something reads it.
    """
    around = [each for each in ancestors(root, place) if each.tag in ("xacro:arg", "xacro:property")]
    if not around or (why := ways.why_unmet(path, root, place)):
        return why if around else ""
    names = [each.get("name") or "" for each in around if each.tag == "xacro:arg"]
    for each in names:
        places = list(readers(ways, each))
        if places and all(ways.why_unmet(one.source.path, one.root, found) for one, found in places):
            return READ_OFF.format(each)
        for_gazebo = (any(up.tag == "gazebo" for up in ancestors(one.root, found)) for one, found in places)
        if places and all(for_gazebo) and is_given_by_spawners(ways, path, each):
            return FOR_GAZEBO.format(each)
    return ""


def readers(ways: WaysIntoRobots, argument: str) -> Iterator[tuple[Document, Span]]:
    """Yield the places of robots that read an argument."""
    read = re.compile(READS.format(re.escape(argument)))
    documents = [each for each in ways.reached.library.documents.values() if each is not None]
    for each in documents:
        yield from ((each, Span(*found.span())) for found in read.finditer(each.source.text))


def is_given_by_spawners(ways: WaysIntoRobots, path: str, argument: str) -> bool:
    """Return whether each launch file that has Gazebo spawn a robot of the package gives an argument, and one does."""
    own, stem = ways.reached.package.name, path.rpartition("/")[2].partition(".")[0]
    others = (facts.robot_words for facts in ways.reached.workspace.packages if facts.name != own)
    found = [words for each in others for words in each if own in words]
    texts = (text for other, text in ways.opened.texts.every if other.endswith(LAUNCH))
    found += [words_of(text) | given_in(text) for text in texts if stem in text]
    spawning = [words for words in found if not SPAWNERS.isdisjoint(words)]
    given = (any(each == f"{argument}=" or each.startswith(f"{argument}:=") for each in words) for words in spawning)
    return bool(spawning) and all(given)
