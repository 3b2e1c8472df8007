"""Checks on whether the place of a finding is ever used; each is imported only once a finding needs it."""

from __future__ import annotations

from ...finding import Hit, Severity
from .finding_builder import OF_STARTS
from .run_rules import InputsOf

OF_LAUNCHES = ("DEP", "LCH", "PRM")
"""Families of rules that report launch files."""
ASKING = frozenset({"LCH003", "LCH004"})
"""Rules that check themselves whether a launch reaches a place, by how it opens the file that is named there."""


def is_left(inputs: InputsOf, path: str) -> bool:
    """Return whether nothing of a package uses a file."""
    from ...checks.left_files import LeftFiles

    return any(each.has(path) for each in inputs(LeftFiles))


def why_warning(inputs: InputsOf, hit: Hit) -> str:
    """Return why a fault that ends a run matters only at times; "" where it always does."""
    from ...checks.reached_places import ReachedPlaces
    from ...checks.unstarted_programs import UNSTARTED, UnstartedPrograms

    if any(each.has(hit.path) for each in inputs(UnstartedPrograms)):
        return UNSTARTED
    return next((each.why_milder(hit.path, hit.span) for each in inputs(ReachedPlaces)), "")


def why_unmet(inputs: InputsOf, code: str, level: Severity, hit: Hit) -> str:
    """Return why neither a start nor a launch with its defaults reaches a hit; "" where one may."""
    if code in OF_STARTS and hit.path.endswith(".py"):
        from ...checks.unintended_starts import UnintendedStarts

        if why := next((each.why(hit.path, hit.span) for each in inputs(UnintendedStarts)), ""):
            return why
    if not code.startswith(OF_LAUNCHES) or code in ASKING or "launch" not in hit.path:
        return ""
    from ...checks.launch.unmet_places import UnmetPlaces
    from .met_in_launch import why_unmet

    return next((why_unmet(each, code, level, hit) for each in inputs(UnmetPlaces)), "")
