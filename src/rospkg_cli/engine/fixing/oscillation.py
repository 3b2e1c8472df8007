"""Which fixes never come to rest: those that are applied round after round and wanted again."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from ...finding import Finding

MAX_ROUNDS = 12
"""Fixes that touch each other wait for the next round; real packages need four at most."""


def oscillating(applied: Sequence[Finding], left: Sequence[Finding]) -> list[Finding]:
    """Return, one for each code and path, the wanted findings whose like was fixed most often; never nothing."""
    times = Counter((each.code, each.location.path) for each in applied)
    once = {(each.code, each.location.path): each for each in left}
    most = max(times[key] for key in once)
    return [each for key, each in once.items() if times[key] == most]
