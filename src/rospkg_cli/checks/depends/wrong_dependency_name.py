"""What is wrong with the name of a dependency, and what to write instead."""

from __future__ import annotations

from ...light_dataclasses import dataclass

UNKNOWN_KEY = "Cannot locate rosdep definition for [{}]"


@dataclass(frozen=True, slots=True)
class WrongDependencyName:
    """A wrong name: the reason is the rest of a sentence, `is its name on PyPI`."""

    reason: str
    suggestion: str | None = None
    advice: str = ""
    """What to do; "" where it is to write the suggestion."""
    rosdep_error: str = UNKNOWN_KEY
    """What rosdep prints; `{}` is the name."""
    parts: tuple[str, ...] = ()
    """The names, where one tag holds several."""
