"""Several names in one clause of a message."""

from __future__ import annotations

from collections.abc import Iterable


def enumerated(names: Iterable[str]) -> str:
    """Return one or more names, each once.

    >>> enumerated("abca")
    'a, b and c'
    """
    *others, last = dict.fromkeys(names)
    return f"{', '.join(others)} and {last}" if others else last


def in_ticks(names: Iterable[str]) -> str:
    """Return one or more names, each once and in backticks.

    >>> in_ticks(["ros2launch"])
    '`ros2launch`'
    """
    return enumerated(f"`{name}`" for name in names)
