"""The faults of launch files that are asked whether a plain launch meets them, whichever rule tells of them."""

from __future__ import annotations

from ...checks.launch.unmet_places import UnmetPlaces
from ...finding import ALSO, Hit, Severity
from ...source import Span

OF_THAT_FACT = frozenset({"LCH001", "LCH010", "LCH012", "LCH017"})
"""Rules about the file as a whole, and one that tells of arguments which come to nothing."""
AT_VISITS = ("LCH002", "LCH009", "LCH011", "LCH015", "LCH019", "LCH021", "LCH022", "PRM")
"""What shows itself when launch visits the action or reads the value; at all else Python itself may stop."""
WITH_WARNINGS = "LCH014"
"""With its warnings the launch goes on; at its errors Python may stop."""

Place = tuple[str, Span]
"""The path of a file in the package, and where in it."""


def shows_at_visit(code: str, level: Severity) -> bool:
    """Return whether a fault shows itself when launch visits an action, or reads a value for one."""
    return code.startswith(AT_VISITS) or (code == WITH_WARNINGS and level is Severity.WARNING)


def places_of(hit: Hit) -> list[Place]:
    """Return all places at which a hit is met."""
    also = (each for each in hit.related if each.message in ALSO)
    return [(hit.path, hit.span), *((each.path, each.span) for each in also)]


def why_unmet(launches: UnmetPlaces, code: str, level: Severity, hit: Hit) -> str:
    """Return why no plain launch comes to any of the places of a hit; "" where one may come to some."""
    places, is_late = places_of(hit), shows_at_visit(code, level)
    reasons = [launches.why_unstarted(path) for path, _ in places]
    if all(reasons):
        return reasons[0]
    if code in OF_THAT_FACT:
        return ""
    reasons = [why or launches.why(*each, is_late=is_late) for why, each in zip(reasons, places, strict=True)]
    return reasons[0] if all(reasons) else ""
