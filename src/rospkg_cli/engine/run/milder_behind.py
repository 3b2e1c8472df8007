"""Findings that become infos as a fault before them ends the run; looked for only where there is such a fault."""

from __future__ import annotations

from ...finding import Finding, Severity
from .finding_builder import AT_RUN
from .milder import RuleResults
from .run_rules import InputsOf

ENDING_LAUNCHES = "LCH013"
"""The rule whose errors are on places of a launch file at which Python raises."""


def milder_behind(results: RuleResults, inputs: InputsOf, folder: str) -> RuleResults:
    """Return results with an info for each fault that is not reached, as the run ends or waits before it.

    Args:
        folder: of the package, from the root of the run.
    """
    loud = [each for each in results if isinstance(each, Finding) and each.is_loud]
    if any(each.code in AT_RUN for each in loud):
        from .earlier_faults import EarlierFaults

        results = next((each.milder(results) for each in inputs(EarlierFaults)), results)
    stops = [each for each in loud if each.code == ENDING_LAUNCHES and each.severity is Severity.ERROR]
    if stops:
        from .ended_launches import behind_ended_launches

        results = behind_ended_launches(results, stops, inputs, folder)
    return results
