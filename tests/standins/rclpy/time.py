"""A point in time."""

from __future__ import annotations


class Time:
    def now(self) -> Time:
        """Return itself: a clock of the stand-ins is a time."""
        return self

    def to_msg(self) -> None:
        """Return nothing: the stand-ins' messages take any stamp."""
