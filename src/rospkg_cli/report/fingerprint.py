"""What a finding is known by from run to run: stable against moved lines."""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Iterable, Iterator

from ..finding import Finding
from . import Report


def fingerprints(report: Report, findings: Iterable[Finding]) -> Iterator[tuple[Finding, str]]:
    """Yield each finding with a hash of its code, path and message, and of its number among equal ones."""
    seen: Counter[tuple[str, str, str]] = Counter()
    for finding in findings:
        key = (finding.code, report.path(finding.location.path), finding.message)
        seen[key] += 1
        yield finding, hashlib.sha256("\0".join((*key, str(seen[key]))).encode("utf-8", "surrogatepass")).hexdigest()
