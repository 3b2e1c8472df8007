"""Findings by package, the worst last: what must be done first stands next to the prompt."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from ..finding import Finding, Severity


def by_package(findings: Iterable[Finding]) -> list[tuple[str, list[Finding]]]:
    """Return the packages that have findings with them; the package with most errors, and its errors, last."""
    found: dict[str, list[Finding]] = {}
    for finding in findings:
        found.setdefault(finding.package, []).append(finding)
    for each in found.values():
        each.sort(key=lambda finding: (finding.severity.rank, *finding.sort_key))
    return sorted(found.items(), key=lambda entry: (*badness(entry[1]), entry[0]))


def badness(findings: Iterable[Finding]) -> tuple[int, int, int]:
    """Return the numbers of errors, warnings and infos."""
    counts = Counter(finding.severity for finding in findings)
    return counts[Severity.ERROR], counts[Severity.WARNING], counts[Severity.INFO]


def by_rule(findings: Iterable[Finding]) -> list[list[Finding]]:
    """Return the findings of one package in groups of one rule and level, in the order of the first of each."""
    found: dict[tuple[str, Severity], list[Finding]] = {}
    for finding in findings:
        found.setdefault((finding.code, finding.severity), []).append(finding)
    return list(found.values())
