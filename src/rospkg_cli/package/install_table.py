"""The install table: each file below the install prefix after the build, and the position that installs it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from ..languages.cmake.call_stack import PYTHON as PYTHON
from ..light_dataclasses import dataclass
from ..source import Span
from ..unreadable import Unreadable
from .package_facts import NOWHERE

InstallKind = Literal["executable", "share", "module", "library", "header", "other"]


@dataclass(frozen=True, slots=True)
class InstalledFile:
    """One installed file."""

    what: InstallKind
    destination: str
    """Relative to the prefix: `share/my_pkg/launch/a.launch.py`, `lib/my_pkg/talker`, `lib/python/my_pkg/talker.py`."""
    source: str = ""
    """The file of the package that it is a copy of; "" where the build makes it."""
    entry: str = ""
    """`module:attribute` of an executable that calls a function."""
    path: str = ""
    """The file that installs it; `span` is the position in it."""
    span: Span = NOWHERE
    maybe: bool = False
    """It is installed only under a condition that can't be evaluated."""
    testing: bool = False
    """It is installed only where tests are built, as colcon does by default."""


@dataclass(frozen=True, slots=True)
class UnknownPart:
    """A part of the table that is unknown."""

    what: InstallKind
    why: str | Unreadable
    """The part of a sentence, or the file that would tell."""
    path: str
    span: Span
    below: str = ""
    """The one folder of the prefix that it is about; "" where it may be any."""
    command: str = ""
    """The command of another package that may install it; "" where it is for another reason."""


@dataclass(frozen=True)
class InstallTable:
    rows: tuple[InstalledFile, ...] = ()
    unknown: tuple[UnknownPart, ...] = ()

    def of(self, what: InstallKind) -> Iterator[InstalledFile]:
        return (row for row in self.rows if row.what == what)

    def below(self, folder: str) -> Iterator[tuple[str, InstalledFile]]:
        """Yield the rows below a folder of the prefix, with their path relative to it."""
        prefix = folder.rstrip("/") + "/"
        return ((row.destination[len(prefix) :], row) for row in self.rows if row.destination.startswith(prefix))

    def knows(self, what: InstallKind) -> bool:
        return all(each.what != what for each in self.unknown)

    def knows_folder(self, what: InstallKind, folder: str) -> bool:
        """Return whether all is known that lies in a folder of the prefix."""
        parts = (f"{each.below}/" for each in self.unknown if each.what == what)
        return not any(part == "/" or part.startswith(f"{folder}/") or f"{folder}/".startswith(part) for part in parts)

    def destination_of(self, source: str) -> str | None:
        """Return where a file or folder of the package goes below the prefix."""
        for row in self.rows:
            if row.source == source:
                return row.destination
            rest = row.source.removeprefix(source)
            if row.source.startswith(f"{source}/") and row.destination.endswith(rest):
                return row.destination.removesuffix(rest)
        return None

    def joined(self, other: InstallTable) -> InstallTable:
        return InstallTable(tuple(dict.fromkeys(self.rows + other.rows)), self.unknown + other.unknown)
