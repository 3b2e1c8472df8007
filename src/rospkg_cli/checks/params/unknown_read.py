"""A parameter that code gets and nothing declares, and what else may declare it or catch the exception."""

from __future__ import annotations

import re

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Source, Span

BASE, ASKED = "; unless its base class does", "; unless other code does, as `has_parameter` is asked first"
MILD = regex(r"\bcatch\b|\bhas_parameter\b|\bexcept\s*(?::|.*\b(?:Base)?Exception\b|.*\bParameter)")
"""What may catch the exception, or ask before."""


@dataclass(frozen=True, slots=True)
class UnknownRead:
    """A parameter that code gets and nothing declares."""

    path: str
    span: Span
    name: str
    suggestion: str
    """"" where the file gets all else that it declares."""
    throws: bool
    """Whether it certainly throws: it gets one parameter by its name, and nothing in the file may catch that."""
    is_python: bool = False
    has_others: bool = False
    """Whether the file declares all others that it gets."""
    on_request: bool = False
    """Whether only a request to a service or an action reaches it."""
    is_dropped: bool = False
    """Whether nothing reads the variable that it is got into."""
    unless: str = ""
    """What else may declare it: a base class that is not here, or other code, as `has_parameter` is asked first."""
    has_other: bool = False
    """Whether the variable is set to an alternative."""
    more: tuple[tuple[str, Span], ...] = ()
    """Other names of the file of which the same is true, and their places."""


def is_asked_for(source: Source, name: str) -> bool:
    """Return whether a file calls `has_parameter` with a name."""
    return re.search(rf"has_parameter\s*\(\s*['\"]{re.escape(name)}['\"]", source.text) is not None
