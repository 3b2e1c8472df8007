"""Where pages and scripts of a repository build a folder without colcon: by CMake, make, pip, or its setup.py."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from ...lazy_regex import regex

STEP = regex(
    r"""(?:\b(?:cd|pushd|WORKDIR)|\bworking-directory:)[ \t]+["']?(?P<to>[\w./~${}-]+)
      | \b(?:cmake|make|meson|ninja|catkin_make|catkin[ \t]+build|pip3?[ \t]+install(?![^\n]*[ ]-r)
            |python3?[ \t]+\S*setup\.py[ \t]+(?:install|develop|build)
            |docker(?:[ -]compose)?[ \t]+build)\b(?P<words>[^\n#;&|`]*)""",
    re.VERBOSE,
)
"""A change of the folder, or a build with its words."""


def is_built_by_hand(texts: tuple[str, ...], folder: str) -> bool:
    """Return whether a text builds a folder, or one in it: `cd serial && mkdir build && cd build && cmake ..`."""
    return any(f"/{folder}/" in f"/{place}/" for text in texts if folder in text for place in places_in(text))


def places_in(text: str) -> Iterator[str]:
    """Yield the folders in which commands of a text build, or that they pass to a build tool, if literal."""
    here = ""
    for step in STEP.finditer(text):
        if step["to"]:
            here = posixpath.normpath(posixpath.join(here, step["to"]))
        else:
            given = (word.strip("\"'").removeprefix("-S") for word in step["words"].split())
            yield from {here, *(posixpath.normpath(posixpath.join(here, word)) for word in given if word)}
