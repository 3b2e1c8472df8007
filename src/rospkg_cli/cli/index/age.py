"""How old the index of names is, and when that has to be said."""

from __future__ import annotations

from collections.abc import Iterable
from datetime import datetime, timezone

from ...finding import Finding
from ...ros.name_index import Index
from ...ros.names import FetchedNames, Names
from ..streams import say

OLD = 90
"""Days after which packages that were released meanwhile may be taken for unknown."""

ASKS = "DEP001"
"""The rule that tells unknown names."""


def age(index: Index) -> int:
    """Return how many days ago an index was fetched."""
    then = datetime.strptime(index.fetched, "%Y-%m-%dT%H:%M:%SZ").replace(tzinfo=timezone.utc)
    return max(0, (datetime.now(timezone.utc) - then).days)


def in_words(days: int) -> str:
    return "today" if days == 0 else "yesterday" if days == 1 else f"{days} days ago"


def warn_of_age(names: Names, findings: Iterable[Finding]) -> None:
    """Say on stderr that the index is old, where names were told by it."""
    if isinstance(names, FetchedNames) and any(finding.code == ASKS for finding in findings):
        days = age(names.index)
        if days > OLD:
            say(f"the index of names is {days} days old; `rospkg index update` fetches it anew")
