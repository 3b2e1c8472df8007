"""Fix in rounds: apply what fits together, lint again, until nothing changes; nothing here touches the disk."""

from __future__ import annotations

from collections.abc import Sequence

from ...finding import Finding, Safety, Severity
from ...light_dataclasses import replace
from ...package.run_events import RuleCrash
from ..run.results import Results
from ..run.session import Session
from .fix_results import FixResults
from .oscillation import MAX_ROUNDS, oscillating
from .overlay import Overlay
from .round import one_round

MAX_STARTS = 5
"""How often fixing begins anew without the fixes that did not come to rest, before nothing is fixed at all."""

Ban = tuple[str, str]
"""Code and path."""


def fix_all(session: Session, safety: Sequence[Safety], level: Severity = Severity.INFO) -> FixResults:
    """Fix everything of a level or above that may be fixed and that the session's filter leaves; it always ends.

    Each round applies at least one fix or is the last. A fix that is still wanted after MAX_ROUNDS never
    settles: fixing starts again without it.
    """
    first = session.run()
    banned: set[Ban] = set()
    refused: list[tuple[Finding, str]] = []
    for _ in range(MAX_STARTS):
        found, left = fix_without(session, first, safety, level, banned)
        if not left:
            found.refused = refused + found.refused
            found.changes = {p: e for p, e in found.changes.items() if e != original_entry(session, p)}
            known = {finding_key(each) for each in first.findings}
            found.uncovered = sum(finding_key(each) not in known for each in found.applied)
            return found
        guilty = oscillating(found.applied, left)
        refused += [(each, "it is found again after each fix; please report this") for each in guilty]
        banned |= {(each.code, each.location.path) for each in guilty}
    return FixResults(first, refused=refused)


def fix_without(
    session: Session, first: Results, safety: Sequence[Safety], level: Severity, banned: set[Ban]
) -> tuple[FixResults, list[Finding]]:
    """Return what MAX_ROUNDS of fixing come to, and the findings whose fix is wanted even then."""
    found, taken_back, crashes = FixResults(first), set[tuple[str, str, str]](), list[RuleCrash]()

    def wanted() -> list[Finding]:
        may_be = [
            f for f in found.results.findings if f.fix and f.fix.safety in safety and f.severity.rank >= level.rank
        ]
        return [f for f in may_be if finding_key(f) not in taken_back and (f.code, f.location.path) not in banned]

    for _ in range(MAX_ROUNDS):
        if not (left := wanted()):
            break
        changes, applied, refused = one_round(
            Overlay(session.tree, found.changes), session.scope.folders, left, found.results.checksums
        )
        taken_back |= {finding_key(each.finding) for each in refused}
        found.refused += [(each.finding, each.why) for each in refused]
        crashes += [each.crash for each in refused if each.crash]
        if applied:
            found.changes = {**found.changes, **changes}
            found.applied += applied
            found.results = replace(session, tree=Overlay(session.tree, found.changes)).run()
    if crashes:
        found.results = session.with_crashes(found.results, crashes)
    return found, wanted()


def finding_key(finding: Finding) -> tuple[str, str, str]:
    return finding.code, finding.location.path, finding.message


def original_entry(session: Session, path: str) -> object:
    try:
        return session.tree.entry(path)
    except OSError:
        return None
