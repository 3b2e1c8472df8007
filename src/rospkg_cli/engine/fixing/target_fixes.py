"""What is wrong for one distribution and not for those before it, and its fixes."""

from __future__ import annotations

from ...finding import Finding, Safety, Severity
from ...light_dataclasses import dataclass, replace
from ...ros.distros import DISTROS, Targets
from ..run.session import Session
from .fix import fix_all
from .fix_results import FixResults


@dataclass(frozen=True)
class TargetFixes:
    """Findings of one distribution: those that were fixed, those that are left, and what changes."""

    found: tuple[Finding, ...]
    left: tuple[Finding, ...]
    fixes: FixResults


def target_fixes(session: Session, distro: str) -> TargetFixes:
    """Fix in memory, safely or not, what a distribution makes wrong; what is wrong for older ones too stays.

    A finding is of the distribution where the older ones have none, or a milder one, in the same line.
    """
    names = [each.name for each in DISTROS]
    older = Targets(tuple(names[: names.index(distro)]))
    known = {key(each): each.severity.rank for each in replace(session, targets=older).run().findings}
    new = replace(session, targets=Targets((distro,)))
    found = [each for each in new.run().findings if each.severity.rank > known.get(key(each), -1)]
    codes = frozenset(each.code for each in found)
    if not codes:
        return TargetFixes((), (), FixResults(new.run()))
    fixes = fix_all(replace(new, codes=codes), (Safety.SAFE, Safety.UNSAFE), Severity.INFO)
    after = {(each.code, each.location.path, each.message) for each in fixes.results.findings}
    left = [each for each in found if (each.code, each.location.path, each.message) in after]
    return TargetFixes(tuple(found), tuple(left), fixes)


def key(finding: Finding) -> tuple[str, str, int]:
    return finding.code, finding.location.path, finding.location.line
