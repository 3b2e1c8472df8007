"""Infos that say the same of several packages: one finding of a run, with the other places as related ones."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable

from ..finding import Finding, Severity
from ..lazy_regex import regex
from ..light_dataclasses import replace

ASIDE = regex(r"\s*\([^()]*\)")
"""What is in parentheses (a version, a number of calls) may differ between packages."""


def with_shared_infos(findings: Iterable[Finding]) -> tuple[Finding, ...]:
    """Return the findings in their order; an info that several packages share is only at its first place.

    An old `cmake_minimum_required` is in all packages of a repository or in none, so that one decision settles it.
    Errors and warnings are listed one by one, since each of them is to be fixed.
    """
    found = tuple(findings)
    same: dict[tuple[str, str], list[Finding]] = defaultdict(list)
    for finding in found:
        if finding.severity is Severity.INFO:
            same[finding.code, ASIDE.sub("", finding.message)].append(finding)
    shared = [each for each in same.values() if len({finding.package for finding in each}) > 1]
    first = {id(each[0]): each[1:] for each in shared}
    left_out = {id(finding) for others in first.values() for finding in others}
    return tuple(with_places(f, first.get(id(f), ())) for f in found if id(f) not in left_out)


def with_places(finding: Finding, others: Iterable[Finding]) -> Finding:
    """Return a finding with the places of others that say the same."""
    places = tuple((other.location, "and here") for other in others)
    return replace(finding, related=(*finding.related, *places)) if places else finding
