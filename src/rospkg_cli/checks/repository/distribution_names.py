"""Names of ROS 2 distributions in texts and paths."""

from __future__ import annotations

from functools import lru_cache

from ...lazy_regex import regex
from .denied_distributions import EVERY, without_denied

BEFORE_DASHING = ("bouncy", "crystal")
"""English words as well, which count only behind `ros`."""
BEFORE_ELOQUENT = (*BEFORE_DASHING, "dashing")
OLDER = (*BEFORE_ELOQUENT, "eloquent", "foxy")
UNSUPPORTED = (*OLDER, "galactic")
BEFORE_JAZZY = (*UNSUPPORTED, "humble", "iron")
BEFORE_LYRICAL = (*BEFORE_JAZZY, "jazzy", "kilted")
NAMES = regex(rf"(?<![a-z])({EVERY})(?![a-z])")
EARLY = regex(rf"\bros[ _-]?2?(?:_?distro)?[\s:=/_-]{{0,3}}[\"']?({'|'.join(BEFORE_DASHING)})\b")
SLIPS = {"elequent": "eloquent", "eloquant": "eloquent", "galatic": "galactic", "galictic": "galactic"}
IN_PATHS = regex(rf"(?<![a-z])({'|'.join(SLIPS)}|{EVERY})(?![a-z])")


@lru_cache(maxsize=1000)
def names_in(text: str) -> frozenset[str]:
    """Return the distributions that a text in lower case names and does not rule out; kept, as packages share pages."""
    text = without_denied(text)
    return frozenset((*NAMES.findall(text), *EARLY.findall(text)))


def names_older(path: str) -> bool:
    """Return whether a path names only distributions before Galactic."""
    found = called(path)
    return bool(found) and found.issubset(OLDER)


def is_called_older(path: str) -> bool:
    """Return whether a path names a distribution that is no longer supported."""
    return not called(path).isdisjoint(UNSUPPORTED)


def called(path: str) -> frozenset[str]:
    """Return the distributions that a path names, also in a known misspelling."""
    return frozenset(SLIPS.get(name, name) for name in IN_PATHS.findall(path.lower()))
