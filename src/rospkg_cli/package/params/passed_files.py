"""The parameter files that a package's own launch files pass to nodes."""

from __future__ import annotations

import re
from collections.abc import Iterator
from posixpath import normpath

from ...files import ReaderInput
from ...lazy_regex import regex
from ..launch.launch_file import LaunchFile
from ..launch.launched_parts import LaunchedNode
from ..launch.never_launched import never_launched
from ..launch.text import LaunchText, Literal, Substitution
from ..manifest import Manifest

READ_BY_RCL = frozenset({"node", "lifecycle_node", "node_container"})
"""What is started as a process of its own; components get what launch_ros reads by itself."""
MAX_DEPTH = 5
IN_SHARE = regex(r"\0([^\0]+)\0/+([^\0]+\.ya?ml)")


def handed_files(reading: ReaderInput) -> frozenset[str]:
    """Return the paths of this package's files that are passed to nodes by a literal name."""
    manifest = reading.parts(Manifest).only
    own = manifest.name if manifest else ""
    handed = (path for package, path in handed_yaml(reading) if package == own)
    return frozenset(path for path in handed if reading.files.exists(path))


def handed_yaml(reading: ReaderInput) -> frozenset[tuple[str, str]]:
    """Return the parameter files that a package's launch files pass to nodes by a literal name: package and path.

    The path is that below the share directory of the package, which may be another one.
    """
    return frozenset(
        found
        for launch in reading.parts(LaunchFile).good
        for node in started(launch)
        if node.kind in READ_BY_RCL
        for entry in node.parameters
        if entry.file is not None
        for found in path_in_share(entry.file, launch)
    )


def yaml_readers(reading: ReaderInput) -> frozenset[tuple[str, str, str, str]]:
    """Return the same files with package and executable of each node, "" for what is not literal.

    A component counts as well, without an executable.
    """
    return frozenset(
        (*found, literal_of(node.package), literal_of(node.executable))
        for launch in reading.parts(LaunchFile).good
        for node in started(launch)
        for entry in node.parameters
        if entry.file is not None
        for found in path_in_share(entry.file, launch)
    )


def started(launch: LaunchFile) -> Iterator[LaunchedNode]:
    """Yield the nodes that a launch file of ROS 2 adds to its description, perhaps under a condition."""
    lost = never_launched(launch.python) if launch.python is not None else ()
    for node in launch.nodes if not launch.is_ros1 else ():
        if not any(span.contains(node.span) for span in lost):
            yield node


def literal_of(text: LaunchText | None) -> str:
    return (text.literal or "") if text is not None else ""


def path_in_share(text: LaunchText, launch: LaunchFile) -> Iterator[tuple[str, str]]:
    """Yield a package and the path below its share directory, where every part of it is known."""
    whole = known_text(text, launch, 0)
    found = IN_SHARE.fullmatch(whole) if whole is not None else None
    if found is not None:
        yield found.group(1), normpath(re.sub("/+", "/", found.group(2)))


def known_text(text: LaunchText, launch: LaunchFile, depth: int) -> str | None:
    """Return a text with each share directory as `\0name\0`; None where a part of it is not known."""
    found = ""
    for part in text.parts:
        piece: str | None = None
        match part:
            case Literal(text=literal):
                piece = literal
            case Substitution(name="find-pkg-share", arguments=(package, *_)) if package.literal:
                piece = f"\0{package.literal}\0"
            case Substitution(name="var", arguments=(name, *_)) if depth < MAX_DEPTH:
                defaults = [each.default for each in launch.arguments if each.name.literal == name.literal]
                if len(defaults) == 1 and defaults[0] is not None:
                    piece = known_text(defaults[0], launch, depth + 1)
        if piece is None:
            return None
        found += piece
    return found
