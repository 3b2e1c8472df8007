"""Where it must be asked whether a fault of Python code stands behind another one that ends the run."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ...finding import Finding, Severity
from ...package.run_events import RuleCrash
from .finding_builder import AT_RUN


def milder_behind(results: list[Finding | RuleCrash], inputs: Callable[[type], list[Any]]) -> list[Finding | RuleCrash]:
    """Return results with an info for each fault that nobody meets as long as the run ends or waits before."""
    at_run = (each for each in results if isinstance(each, Finding) and each.code in AT_RUN)
    if all(each.severity is Severity.INFO for each in at_run):
        return results
    from .earlier_faults import EarlierFaults

    return next((each.milder(results) for each in inputs(EarlierFaults)), results)
