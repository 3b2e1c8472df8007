"""Where a file names paths in a home folder, outside of comments and of texts that are only shown."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...languages.python.file import PythonFile
from ...light_dataclasses import dataclass
from ...source import Span
from ..paths.home_path_texts import patterns
from ..paths.shown_texts import is_only_shown


@dataclass(frozen=True, slots=True)
class HomeMention:
    """The first place of a file that names a path."""

    path: str
    """Of the file."""
    bare: str
    """The text of the file, with blanks in place of comments."""
    start: int
    """Where the value begins: before the path there may be `file://`."""
    place: Span
    """Of the path itself."""
    named: str
    user: str
    """The account whose home folder it is."""

    @property
    def before(self) -> str:
        return self.bare[: self.place.start]

    @property
    def is_image(self) -> bool:
        """Whether it is the image of a map: the value of `image:`."""
        return self.before.rstrip(" \t\"'").endswith("image:")


def home_mentions(path: str, bare: str, file: PythonFile | None) -> Iterator[HomeMention]:
    """Yield each home path of a file once, in the order of the text."""
    places: dict[str, re.Match[str]] = {}
    for pattern in patterns(path):
        for match in pattern.finditer(bare):
            if not is_only_shown(path, bare, Span(*match.span("path")), file):
                places.setdefault(match["path"], match)
    for named, match in sorted(places.items(), key=lambda each: each[1].start()):
        yield HomeMention(path, bare, match.start(), Span(*match.span("path")), named, match["user"] or match["mac"])
