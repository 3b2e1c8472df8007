"""What a word of few letters stands for: `sub` for `subscriber`, `costmap` for `costmap-layer`, `CI` for `ci`."""

from __future__ import annotations

from collections.abc import Iterable

from ..suggest import did_you_mean


def closest_name(word: str, names: Iterable[str]) -> str:
    """Return ` (did you mean `x`?)` for a misspelt name, or for a part that only one name has; else nothing."""
    names, small = list(names), word.lower()
    having = [name for name in names if len(small) > 1 and small in name]
    return did_you_mean(word, names) or (f" (did you mean `{having[0]}`?)" if len(having) == 1 else "")
