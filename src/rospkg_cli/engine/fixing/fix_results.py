"""What a run with fixes comes to."""

from __future__ import annotations

from ...finding import Finding
from ...light_dataclasses import dataclass, field
from ...tree import TreeEntry
from ..run.results import Results


@dataclass
class FixResults:
    """The results of a run with fixes."""

    results: Results
    """Of the last round."""
    changes: dict[str, TreeEntry | None] = field(default_factory=dict)
    """Against the tree as it was; paths relative to the root of the run."""
    applied: list[Finding] = field(default_factory=list)
    refused: list[tuple[Finding, str]] = field(default_factory=list)
    """Findings whose fix was taken back, and why."""
    uncovered: int = 0
    """How many of the applied were not there before the first round."""
