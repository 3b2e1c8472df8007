"""What lint says after a change that it did not say before."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable

from ..engine.fixing.overlay import Overlay
from ..engine.run.results import Results
from ..engine.run.session import Session
from ..finding import Finding, Severity
from ..light_dataclasses import dataclass, replace
from . import ChangeError
from .draft import Draft

UNCHECKED = "RPK008"
"""The rule that reports what can't be checked here: it judges nothing."""


@dataclass(frozen=True)
class Judgement:
    """Lint of the selected packages before and after a change."""

    before: Results
    after: Results
    changed: frozenset[str] = frozenset()
    """The files that were changed or made."""

    @property
    def new(self) -> tuple[Finding, ...]:
        """The findings that are there since the change.

        A line that moved is the same finding, and so is one that counts or names something more in its message. Infos
        are those of the changed files: they tell of nothing that fails, and a declared package lets others be seen.
        """
        after, before = list(self.after.findings), list(self.before.findings)
        for key in (exactly, at_its_line):
            known = Counter(map(key, before))
            after, matched = left_over(after, known, key), Counter(map(key, after))
            before = left_over(before, matched, key)
        return tuple(each for each in after if self.matters(each))

    @property
    def unchecked(self) -> tuple[str, ...]:
        """What lint says that it could not check, and did not say before."""
        known = {each.message for each in self.before.findings}
        return tuple(
            each.message for each in self.after.findings if each.code == UNCHECKED and each.message not in known
        )

    def matters(self, finding: Finding) -> bool:
        if finding.code == UNCHECKED:
            return False
        return finding.severity is not Severity.INFO or finding.location.path in self.changed


def left_over(
    findings: list[Finding], others: Counter[tuple[str, ...]], key: Callable[[Finding], tuple[str, ...]]
) -> list[Finding]:
    """Return the findings that are none of the others."""
    known, left = Counter(others), []
    for finding in findings:
        if known[key(finding)]:
            known[key(finding)] -= 1
        else:
            left.append(finding)
    return left


def exactly(finding: Finding) -> tuple[str, ...]:
    return finding.code, finding.location.path, finding.message


def at_its_line(finding: Finding) -> tuple[str, ...]:
    return finding.code, finding.location.path, finding.excerpt


def judge(session: Session, draft: Draft, before: Results | None = None) -> Judgement:
    """Lint what is there and what would be; `before` is what lint says now, if known."""
    after = replace(session, tree=Overlay(session.tree, draft.changes))
    return Judgement(before or session.run(), after.run(), frozenset(draft.changes))


def refuse_new(new: Iterable[Finding]) -> None:
    """Raise ChangeError for what lint would report: what was done is taken back."""
    found = [f"{each.location.path}:{each.location.line}: {each.code} {each.message}" for each in new]
    if found:
        raise ChangeError("lint would report what it does not report now, so nothing was written", tuple(found))
