"""CHANGELOG.rst, as far as release tools read it: the versions that it has an entry for (REP-132)."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..files import ReaderInput, read_each
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..source import Source, Span
from .manifest import Manifest

CHANGELOG = "CHANGELOG.rst"

TITLE = regex(
    r"^(?P<version>[0-9]+\.[0-9]+\.[0-9]+)[ ]\([^)\n]*[0-9][^)\n]*\)[ \t]*\n"
    r"""(?P<line>[=~^"'`*+#<>.:_-])(?P=line){2,}[ \t]*$""",
    re.MULTILINE,
)
"""The only form of a title that catkin_pkg reads; it skips all others, `Forthcoming` among them."""

MAX_DIGITS = 100
"""Of a number, so that it can be compared; Python reads none of thousands."""

Number = tuple[int, ...]


@dataclass(frozen=True, slots=True)
class ChangelogEntry:
    version: str
    span: Span
    """Of the version."""

    @property
    def number(self) -> Number:
        return number_of(self.version)


@dataclass(frozen=True)
class Changelog:
    source: Source
    entries: tuple[ChangelogEntry, ...]
    """In the order of the file."""

    @property
    def newest(self) -> ChangelogEntry | None:
        return max(self.entries, key=lambda entry: entry.number, default=None)


@dataclass(frozen=True)
class ManifestAndChangelog:
    """What a release is made of: a version, and what changed in it."""

    manifest: Manifest
    changelog: Changelog


def number_of(version: str) -> Number:
    """Return a version of three numbers as numbers; raises ValueError."""
    return tuple(int(part[:MAX_DIGITS]) for part in version.split("."))


def read_changelog(reading: ReaderInput) -> Iterator[Changelog]:
    """Read the changelog; one that is no text is passed over, as no build reads it."""
    paths = [CHANGELOG] if reading.files.exists(CHANGELOG) else []
    return (read for read in read_each(reading.files, paths, changelog_of) if isinstance(read, Changelog))


def changelog_of(source: Source) -> Changelog:
    return Changelog(
        source, tuple(ChangelogEntry(m["version"], Span(*m.span("version"))) for m in TITLE.finditer(source.text))
    )
