"""What lint says before and after a change of names, compared with the names aside."""

from __future__ import annotations

import re
from collections.abc import Callable

from ..change.judge import Judgement
from ..change.moved_tree import MovedTree
from ..engine.run.results import Results
from ..engine.run.scope import Scope
from ..engine.run.session import Session, keep_all
from ..finding import Finding
from ..light_dataclasses import replace
from .plan import RenamePlan


def judge_rename(session: Session, plan: RenamePlan, old: str, new: str) -> Judgement:
    """Lint the packages that name the old one, as they are and as they would be; configs set nothing aside."""
    scope = replace(session.scope, selected=frozenset(touched(session.scope, plan)))
    plain = replace(session, filter_results=keep_all, codes_by_package=None)
    moved = MovedTree(session.tree, plan.renamed)
    before = replace(plain, scope=scope).run()
    after = replace(plain, tree=plan.draft.tree, scope=moved_scope(scope, moved)).run()
    said = [translated(each, moved.moved, old, new) for each in before.findings]
    now = [translated(each, str, old, new) for each in after.findings]
    return Judgement(
        Results(tuple(said), packages=before.packages),
        Results(tuple(now), packages=after.packages),
        frozenset(plan.draft.changes),
    )


def touched(scope: Scope, plan: RenamePlan) -> set[str]:
    """Return the folders of the packages with files that hold the old name."""
    found = set()
    for path in plan.mentions:
        around = [each for each in scope.folders if not each or path.startswith(f"{each}/")]
        if around:
            found.add(max(around, key=len))
    return found


def moved_scope(scope: Scope, moved: MovedTree) -> Scope:
    """Return the packages under their new folders."""
    return replace(
        scope,
        folders=tuple(sorted(map(moved.moved, scope.folders))),
        selected=frozenset(map(moved.moved, scope.selected)),
        cmake_projects=tuple((name, moved.moved(folder)) for name, folder in scope.cmake_projects),
        repositories=tuple(frozenset(map(moved.moved, each)) for each in scope.repositories),
    )


def translated(finding: Finding, moved: Callable[[str], str], old: str, new: str) -> Finding:
    """Return a finding as it would be with the new name in its path, message and line."""

    def said(text: str) -> str:
        return re.sub(rf"(?<![A-Za-z0-9]){re.escape(old)}(?![A-Za-z0-9])", new, text)

    location = replace(finding.location, path=moved(finding.location.path))
    return replace(finding, location=location, message=said(finding.message), excerpt=said(finding.excerpt))
