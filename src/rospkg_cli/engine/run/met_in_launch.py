"""Whether a launch with its defaults reaches the places of a finding in launch files, whichever rule reports it."""

from __future__ import annotations

from ...checks.launch.unmet_places import UnmetPlaces
from ...finding import ALSO, Hit, Severity
from ...source import Span

OF_THAT_FACT = frozenset({"LCH001", "LCH010", "LCH012", "LCH017"})
"""Rules about the file as a whole, and one on arguments without an effect."""
AT_VISITS = ("LCH002", "LCH009", "LCH011", "LCH015", "LCH019", "LCH021", "LCH022", "PRM")
"""Rules on faults that appear when launch visits an action or reads a value; at others Python itself may stop."""
WITH_WARNINGS = "LCH014"
"""The launch goes on after its warnings; at its errors Python may stop."""

Place = tuple[str, Span]
"""The path of a file in the package, and where in it."""


def shows_at_visit(code: str, level: Severity) -> bool:
    """Return whether a fault appears only when launch visits an action, or reads a value for one."""
    return code.startswith(AT_VISITS) or (code == WITH_WARNINGS and level is Severity.WARNING)


def places_of(hit: Hit) -> list[Place]:
    """Return all places of a hit, with those that have the same fault."""
    also = (each for each in hit.related if each.message in ALSO)
    return [(hit.path, hit.span), *((each.path, each.span) for each in also)]


def why_unmet(launches: UnmetPlaces, code: str, level: Severity, hit: Hit) -> str:
    """Return why a launch with its defaults reaches none of the places of a hit; "" where it may reach one."""
    places, is_late = places_of(hit), shows_at_visit(code, level)
    reasons = [launches.why_unstarted(path) for path, _ in places]
    if all(reasons):
        return reasons[0]
    if code in OF_THAT_FACT:
        return ""
    reasons = [why or launches.why(*each, is_late=is_late) for why, each in zip(reasons, places, strict=True)]
    return reasons[0] if all(reasons) else ""
