"""Values of options: lists with commas, and one of several."""

from __future__ import annotations

from collections.abc import Iterable

from . import UsageError


def split(values: Iterable[str] | None) -> tuple[str, ...]:
    """Return the names of a repeatable, comma-separated option."""
    return tuple(name.strip() for value in values or () for name in value.split(",") if name.strip())


def one_of(option: str, value: str, allowed: tuple[str, ...]) -> None:
    """Raise UsageError where an option has a value that it can't have."""
    if value not in allowed:
        from ..suggest import did_you_mean

        raise UsageError(f"{option} must be one of {', '.join(allowed)}; not `{value}`{did_you_mean(value, allowed)}")
