"""The age of the index of names, and a warning where it is old."""

from __future__ import annotations

from collections.abc import Iterable

from ...cache.recheck import today
from ...disk_trace import note
from ...finding import Finding
from ...ros.name_index import Index
from ...ros.names import FetchedNames, Names
from ..streams import say

OLD = 90
"""Days after which newly released packages may be reported as unknown."""

ASKS = "DEP001"
"""The rule that reports unknown names."""


def age(index: Index) -> int:
    """Return how many days ago an index was fetched."""
    from datetime import datetime, timezone

    then = datetime.strptime(index.fetched, "%Y-%m-%dT%H:%M:%SZ").replace(tzinfo=timezone.utc)
    return max(0, (datetime.now(timezone.utc) - then).days)


def in_words(days: int) -> str:
    return "today" if days == 0 else "yesterday" if days == 1 else f"{days} days ago"


def warn_of_age(names: Names, findings: Iterable[Finding]) -> None:
    """Warn on stderr that the index is old, where a finding depends on it."""
    if isinstance(names, FetchedNames) and any(finding.code == ASKS for finding in findings):
        days = age(names.index)
        note("d", today() if days < OLD else "")  # no answer comes again: it may be older before the day is over
        if days > OLD:
            say(f"the index of names is {days} days old; `rospkg index update` fetches a new one")
