"""What lint says after a change that it did not say before."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable

from ..engine.fixing.overlay import Overlay
from ..engine.run.session import Results, Scope, Session
from ..finding import Finding
from ..light_dataclasses import dataclass, replace
from . import ChangeError
from .draft import Draft


@dataclass(frozen=True)
class Judgement:
    """Lint of the selected packages before and after a change."""

    before: Results
    after: Results

    @property
    def new(self) -> tuple[Finding, ...]:
        """The findings that are there since the change: a line that moved is the same finding."""
        known = Counter(map(identity, self.before.findings))
        found = []
        for finding in self.after.findings:
            if known[identity(finding)]:
                known[identity(finding)] -= 1
            else:
                found.append(finding)
        return tuple(found)


def identity(finding: Finding) -> tuple[str, str, str]:
    return finding.code, finding.location.path, finding.message


def judge(session: Session, draft: Draft, scope: Scope | None = None) -> Judgement:
    """Lint what is there and what would be; `scope` holds the packages after the change, where they are others."""
    after = replace(session, tree=Overlay(session.tree, draft.changes), scope=scope or session.scope)
    return Judgement(session.run(), after.run())


def refuse_new(new: Iterable[Finding]) -> None:
    """Raise ChangeError for what lint would report: what was done is taken back."""
    found = [f"{each.location.path}:{each.location.line}: {each.code} {each.message}" for each in new]
    if found:
        raise ChangeError("lint would report what it does not report now, so nothing was written", tuple(found))
