"""Where it must be asked whether a fault stands behind another one that ends the run of its Python code."""

from __future__ import annotations

from ...finding import Finding, Severity
from ...package.run_events import RuleCrash
from .finding_builder import AT_RUN
from .run_rules import InputsOf

ENDING_LAUNCHES = "LCH013"
"""The rule whose errors say that Python itself raises where it comes to the place."""

Results = list[Finding | RuleCrash]


def milder_behind(results: Results, inputs: InputsOf, folder: str) -> Results:
    """Return results with an info for each fault that nobody meets as long as the run ends or waits before.

    Args:
        folder: of the package, from the root of the run.
    """
    loud = [each for each in results if isinstance(each, Finding) and each.severity is not Severity.INFO]
    if any(each.code in AT_RUN for each in loud):
        from .earlier_faults import EarlierFaults

        results = next((each.milder(results) for each in inputs(EarlierFaults)), results)
    stops = [each for each in loud if each.code == ENDING_LAUNCHES and each.severity is Severity.ERROR]
    if stops:
        from .ended_launches import behind_ended_launches

        results = behind_ended_launches(results, stops, inputs, folder)
    return results
