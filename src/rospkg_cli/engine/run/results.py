"""What a run found."""

from __future__ import annotations

from collections.abc import Mapping

from ...finding import Finding
from ...light_dataclasses import dataclass, field
from ...package.run_events import RuleCrash


@dataclass(frozen=True)
class Results:
    """What a run found; findings are sorted, and `suppressed` ones are listed separately."""

    findings: tuple[Finding, ...] = ()
    suppressed: tuple[Finding, ...] = ()
    crashes: tuple[RuleCrash, ...] = ()
    packages: int = 0
    files: int = 0
    checksums: Mapping[str, int] = field(default_factory=dict)
    """Of the files that fixes change, as they were when the rules read them."""
