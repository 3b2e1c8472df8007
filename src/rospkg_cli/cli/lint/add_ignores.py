"""`rospkg lint --add-ignores REASON`: write the comments, and report what no comment can ignore."""

from __future__ import annotations

from ...engine.fixing.apply import Changes, apply_fixes
from ...engine.fixing.overlay import Overlay
from ...engine.fixing.round import newly_unreadable
from ...engine.fixing.write import write_changes
from ...engine.run.session import Session
from ...engine.suppression.insert_ignores import ignore_comments
from ...finding import Finding
from ...light_dataclasses import replace
from ...report import Report
from .. import UsageError
from ..streams import say


def add_ignores(reason: str, session: Session, report: Report) -> int:
    """Write an ignore comment with a reason for every finding; return 0, or 1 where some remain."""
    if not reason.strip():
        raise UsageError('--add-ignores requires a reason: --add-ignores "vendored, will be replaced"')
    changes, left = with_ignores(session, report.results.findings, reason)
    written = write_changes(report.root, session.tree, changes)
    count = len(report.results.findings) - len(left)
    say(f"findings that are now ignored: {count}, in files: {len(written)}")
    for finding in left:
        say(f"{report.where(finding)}: {finding.code} can't be ignored by a comment; ignore it in rospkg.toml")
    return 1 if left else 0


def with_ignores(session: Session, findings: tuple[Finding, ...], reason: str) -> tuple[Changes, list[Finding]]:
    """Return the changes that add ignore comments, and the findings that remain; no file is made unreadable."""
    base = Overlay(session.tree)
    fixes = list(ignore_comments(session.tree, findings, reason))
    changes, _ = apply_fixes(base, fixes)
    for path in newly_unreadable(base, changes, session.scope.folders):
        changes.pop(path, None)
    after = replace(session, tree=Overlay(session.tree, changes)).run()
    remaining = {(f.code, f.location.path, f.message) for f in after.findings}
    left = [f for f in findings if (f.code, f.location.path, f.message) in remaining]
    return changes, left
