"""Findings of a package that become infos for a reason which no rule sees alone."""

from __future__ import annotations

from collections.abc import Callable

from ...finding import Finding, Severity
from ...light_dataclasses import replace
from ...package.run_events import RuleCrash

Results = list[Finding | RuleCrash]


def as_infos(results: Results, codes: frozenset[str], why: Callable[[Finding], str]) -> Results:
    """Return the results; a louder finding of some rules is an info where there is a reason, which it ends with."""
    return [
        replace(each, severity=Severity.INFO, message=each.message + reason)
        if isinstance(each, Finding) and each.code in codes and is_loud(each) and (reason := why(each))
        else each
        for each in results
    ]


def is_loud(found: Finding) -> bool:
    return found.severity is not Severity.INFO
