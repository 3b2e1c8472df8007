"""A path in one person's home folder, and what is known of it."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...source import Span


@dataclass(frozen=True, slots=True)
class HomePath:
    path: str
    """Of the file that names it."""
    span: Span
    text: str
    of_package: str | None
    """The package of the workspace in whose folders it lies."""
    below: str
    """The rest of the path, below that package or its share directory."""
    is_image: bool
    """Whether it is the image of a map."""
    may_be_there: bool
    """Whether it may exist on other machines: many people have an account of that name, or a container of the
    repository has it. Also where the code can do without it: it checks whether the path exists, tries another one
    first, or handles the error when it can't be opened.
    """
    is_seldom_read: bool
    """Whether the file is rarely read at this path: nothing uses the file that names it (`NamingFiles.is_seldom_read`),
    another value replaces it (`HomePathValues`), people are asked to change it, or it is only one of several places.
    """
    is_unreached: bool = False
    """Whether it is in a function that nothing calls."""
    is_unread: bool = False
    """Whether it is assigned to a variable, or is the default of an argument, that nothing reads."""
    is_written: bool = False
    """Whether it is known to be a file that something writes."""
    is_unclaimed: bool = False
    """Whether it is the value of a parameter (in YAML or in a launch file), and no code here and no well-known node is
    known to read that parameter.
    """
    is_last_resort: bool = False
    """Whether it is tried only after another way to the file failed."""
    is_off: bool = False
    """Whether a switch that is off, or a default that chooses otherwise, keeps the code at this place from running."""
