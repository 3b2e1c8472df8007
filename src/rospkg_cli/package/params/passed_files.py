"""The parameter files that a package's own launch files pass to nodes."""

from __future__ import annotations

import re
from collections.abc import Iterator
from posixpath import normpath

from ...files import ReaderInput
from ..launch.launch_file import LaunchFile
from ..launch.text import LaunchText, Literal, Substitution
from ..manifest import Manifest

READ_BY_RCL = frozenset({"node", "lifecycle_node", "node_container"})
"""What is started as a process of its own; components get what launch_ros reads by itself."""
MAX_DEPTH = 5


def handed_files(reading: ReaderInput) -> frozenset[str]:
    """Return the paths of this package's files that are passed to nodes by a literal name."""
    manifest = reading.parts(Manifest).only
    own = manifest.name if manifest else ""
    return frozenset(
        path
        for launch in reading.parts(LaunchFile).good
        for node in launch.nodes
        if node.kind in READ_BY_RCL and not launch.is_ros1
        for entry in node.parameters
        if entry.file is not None
        for path in path_in_share(entry.file, launch, own)
        if reading.files.exists(path)
    )


def path_in_share(text: LaunchText, launch: LaunchFile, own: str) -> Iterator[str]:
    """Yield the path below the package's share folder, where every part of it is known."""
    parts = list(known_parts(text, launch, own, 0))
    if parts and parts[0] == "" and all(part is not None for part in parts):
        path = normpath(re.sub("/+", "/", "".join(part or "" for part in parts)).lstrip("/"))
        if path.endswith((".yaml", ".yml")):
            yield path


def known_parts(text: LaunchText, launch: LaunchFile, own: str, depth: int) -> Iterator[str | None]:
    """Yield the text of each part, "" for the own share folder, None for what is not known."""
    for part in text.parts:
        match part:
            case Literal(text=literal):
                yield literal
            case Substitution(name="find-pkg-share", arguments=(package, *_)) if package.literal == own:
                yield ""
            case Substitution(name="var", arguments=(name, *_)) if depth < MAX_DEPTH:
                defaults = [each.default for each in launch.arguments if each.name.literal == name.literal]
                if len(defaults) == 1 and defaults[0] is not None:
                    yield from known_parts(defaults[0], launch, own, depth + 1)
                else:
                    yield None
            case _:
                yield None
