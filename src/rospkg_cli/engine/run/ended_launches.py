"""Faults in actions of a launch file that launch never visits, as Python raises before it returns them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import PurePosixPath

from ...finding import Finding, Severity
from ...light_dataclasses import replace
from .earlier_faults import FIRST
from .met_in_launch import shows_at_visit
from .milder import RuleResults
from .run_rules import InputsOf

OF_CONFIGURATIONS = frozenset({"LCH008", "LCH016"})
"""Rules on launch configurations: launch reads their values at the visit, unless Python looks them up itself."""
OF_TEXTS = "DEP118"
"""The rule on personal paths, which are opened by what launch starts."""
BEHIND = "; the launch ends before, at another line"


def behind_ended_launches(results: RuleResults, stops: list[Finding], inputs: InputsOf, folder: str) -> RuleResults:
    """Return results with an info for each fault that launch would meet only if Python reached the end of the file.

    What Python itself meets keeps its level.

    Args:
        stops: findings on places at which Python raises.
        folder: of the package, from the root of the run.
    """
    visited = [each for each in results if isinstance(each, Finding) and is_visited(each)]
    paths = {each.location.path for each in visited}.intersection(each.location.path for each in stops)
    found: dict[int, Finding] = {}
    for path, first in first_stops(stops, paths, inputs, folder) if paths else ():
        for each in visited:
            if each.location.path == path:
                related = (*each.related, (first.location, FIRST))
                message = each.message + BEHIND
                found[id(each)] = replace(each, severity=Severity.INFO, message=message, related=related)
    return [found.get(id(each), each) for each in results]


def is_visited(finding: Finding) -> bool:
    """Return whether a finding is loud and shows itself when launch visits an action, or reads a value for one."""
    path = finding.location.path
    is_text = finding.code == OF_TEXTS and all(place.path == path for place, _ in finding.related)
    is_late = is_text or finding.code in OF_CONFIGURATIONS or shows_at_visit(finding.code, finding.severity)
    return finding.is_loud and is_late


def first_stops(stops: list[Finding], paths: set[str], inputs: InputsOf, folder: str) -> Iterator[tuple[str, Finding]]:
    """Yield the files with the first place at which `generate_launch_description` certainly raises."""
    from ...checks.launch.ended_descriptions import ends_description
    from ...checks.launch.unmet_places import UnmetPlaces

    for places in inputs(UnmetPlaces):
        for scope in places.scopes:
            path, python = str(PurePosixPath(folder, scope.file.path)), scope.file.python
            if path not in paths or python is None or places.is_imported(scope.file.path):
                continue
            own = [each for each in stops if each.location.path == path]
            sure = [each for each in own if ends_description(python, each.location.span)]
            if sure:
                yield path, min(sure, key=lambda each: each.location.span.start)
