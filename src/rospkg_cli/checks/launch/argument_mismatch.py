"""An argument that a launch file gives to an included one and that this does not declare, or one that is missing."""

from __future__ import annotations

from collections.abc import Collection

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Span
from ...suggest import as_near, near_names

SHORTEST = 5
MOST = 3
"""So many similar names, or more, are too many to suggest one of them."""
DIGITS = regex(r"\d")


@dataclass(frozen=True, slots=True)
class ArgumentMismatch:
    span: Span
    file: str
    """The name of the included file."""
    package: str
    argument: str
    is_missing: bool
    """Whether it is required and missing; else it is passed and unknown."""
    suggestion: str | None = None
    """The argument that is probably intended; of a missing one, the misspelt one that is given."""
    is_sure: bool = True
    """Whether nothing that the file includes may take it."""
    rivals: tuple[str, ...] = ()
    """Other arguments that are about as near as the suggestion."""
    is_default: bool = False
    """Whether the value passed is the default of the intended argument, so that nothing differs."""
    why: str = ""
    """Why no launch reaches the include; "" where one may."""

    @property
    def is_fault(self) -> bool:
        """Whether it is more than an argument that is left over, or that a file further on may take."""
        return self.is_missing or (self.is_sure and self.is_clear and not self.is_default)

    @property
    def is_clear(self) -> bool:
        """Whether one argument can be suggested, or a few."""
        return bool(self.suggestion) and len(self.rivals) < MOST


def mistyped(word: str, names: Collection[str]) -> str | None:
    """Return the one name that differs from a word by one letter; not by a number, nor where both are short."""
    near = [name for name in near_names(word, names, 1) if min(len(word), len(name)) >= SHORTEST]
    near = [name for name in near if DIGITS.sub("", name) != DIGITS.sub("", word)]
    return near[0] if len(near) == 1 else None


def rivals_of(word: str, near: str | None, names: Collection[str]) -> tuple[str, ...]:
    """Return the other names that are about as near to a word as the one that is suggested."""
    return tuple(each for each in as_near(word, near, names) if each != near) if near else ()
