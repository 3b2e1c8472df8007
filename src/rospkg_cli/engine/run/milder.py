"""Findings of a package that become infos for a reason that no single rule knows."""

from __future__ import annotations

from collections.abc import Callable

from ...finding import Finding, Severity
from ...light_dataclasses import replace
from ...package.run_events import RuleCrash

RuleResults = list[Finding | RuleCrash]


def as_infos(results: RuleResults, codes: frozenset[str], why: Callable[[Finding], str]) -> RuleResults:
    """Return the results; findings of some rules become infos where `why` returns a reason, which ends the message."""
    return [
        replace(each, severity=Severity.INFO, message=each.message + reason)
        if isinstance(each, Finding) and each.code in codes and each.is_loud and (reason := why(each))
        else each
        for each in results
    ]
