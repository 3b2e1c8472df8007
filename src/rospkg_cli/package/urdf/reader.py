"""Find and read the robot descriptions and worlds of a package."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...files import ReaderInput
from ...languages.xml.parser import Document, Element, read_xml
from ...lazy_regex import regex
from ...read_problem import ReadProblem
from ...source import Source, Span
from ...unreadable import Unreadable, UnreadableError
from ..file_role import role_of
from .references import local_includes, references
from .robot_file import RobotFile

ROBOTS = (".urdf", ".xacro")
WORLDS = (".sdf", ".world")
TINYXML_STOPS = frozenset({ReadProblem.XML_MISMATCH})
"""What Gazebo stops at as well; it reads past two hyphens in a comment and text before `<?xml …?>`."""
DECLARATION = regex(r"\s*(?:<!--.*?-->\s*)*(<\?xml[^>]*\?>)", re.DOTALL)


def read_robot_files(reading: ReaderInput) -> Iterator[RobotFile | Unreadable]:
    """Read urdf, xacro, sdf and world files; of the latter two only what they refer to."""
    for path in reading.files.paths:
        if not path.endswith(ROBOTS + WORLDS) or role_of(path) in ("test", "aside") or is_of_web(reading, path):
            continue
        try:
            source = reading.files.source(path)
            if "<!DOCTYPE" not in source.text:
                yield robot_file(source)
        except UnreadableError as error:
            if path.endswith(ROBOTS) or error.unreadable.code in TINYXML_STOPS:
                yield error.unreadable


def is_of_web(reading: ReaderInput, path: str) -> bool:
    """Return whether a file belongs to a web page: a folder above it in the package holds a package.json of npm."""
    folders = path.split("/")[:-1]
    return any(
        "/".join([*folders[:depth], "package.json"]) in reading.files.paths for depth in range(1, len(folders) + 1)
    )


def robot_file(source: Source) -> RobotFile:
    """Read one file; raises UnreadableError where it is not well formed."""
    plain = not source.path.endswith(".xacro")
    document = read_xml(without_declaration(source) if plain else source, prefixes="<xacro:" in source.text)
    document = Document(source, document.root, document.instructions, document.comments)
    links, joints = parts_of(document.root, "link"), parts_of(document.root, "joint")
    found = tuple(references(document))
    return RobotFile(document, is_xacro(document), links, joints, found, tuple(local_includes(document)))


def without_declaration(source: Source) -> Source:
    """Blank out the `<?xml …?>` line: urdfdom and sdformat accept text before it."""
    match = DECLARATION.match(source.text)
    if match is None:
        return source
    span = Span(*match.span(1))
    return Source(source.path, source.text[: span.start] + " " * (span.end - span.start) + source.text[span.end :])


def is_xacro(document: Document) -> bool:
    text = document.source.text
    return document.source.path.endswith(".xacro") or "xacro:" in text or "${" in text or "$(" in text


def parts_of(root: Element, tag: str) -> tuple[Element, ...]:
    """Return the links or joints of a robot, those in macros and conditions included, those of ros2_control not."""
    found, waiting = [], [root]
    while waiting:
        for child in waiting.pop(0).children:
            if child.tag == tag:
                found.append(child)
            elif child.tag.startswith("xacro:"):
                waiting.append(child)
    return tuple(sorted(found, key=lambda element: element.span))
