"""What an editor offers at a finding: its fix, an ignore with a reason; and all safe fixes of a package."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from lsprotocol import types

from ...engine.fixing.fix import fix_all
from ...engine.suppression.insert_ignores import ignore_comments
from ...finding import Finding, Fix, Safety, Severity
from ...light_dataclasses import replace
from .declare import declarations
from .diagnostics import diagnostic
from .edits import edit_of_changes, is_possible, workspace_edit
from .linted import Linted
from .positions import to_range
from .text_overlay import package_of

FIX_ALL = "source.fixAll.rospkg"
REASON = "say here why"
"""What stands for the reason of an ignore until somebody writes it."""


def actions(linted: Linted, path: Path, asked: types.CodeActionParams) -> Iterator[types.CodeAction]:
    """Yield what can be done at a range of a file."""
    only = asked.context.only
    for finding in linted.by_file.get(path, []):
        at = to_range(linted.codec, linted.source(finding.location.path), finding.location)
        if is_wanted(types.CodeActionKind.QuickFix, only) and touch(at, asked.range):
            yield from fixes(linted, finding)
    if is_wanted(FIX_ALL, only) and linted.by_file.get(path):
        package = linted.by_file[path][0].package
        yield types.CodeAction(f"rospkg: fix all in {package}", kind=FIX_ALL, data={"path": str(path)})


def is_wanted(kind: str, only: Iterable[str] | None) -> bool:
    return only is None or any(kind == each or kind.startswith(f"{each}.") for each in only)


def touch(one: types.Range, other: types.Range) -> bool:
    """Return whether two ranges share a line: a cursor need not stand in what is wrong."""
    return one.start.line <= other.end.line and other.start.line <= one.end.line


def fixes(linted: Linted, finding: Finding) -> Iterator[types.CodeAction]:
    """Yield the fix of a finding, what else mends it, and the comment that ignores it."""
    shown = [diagnostic(finding, linted, linted.codec)]
    if finding.fix and is_possible(finding.fix):
        title = f"{finding.fix.title} ({finding.code})"
        yield quick_fix(title, finding.fix, linted, shown, is_preferred=finding.fix.safety is Safety.SAFE)
    for fix in declarations(linted, finding):
        yield quick_fix(f"{fix.title} ({finding.code})", fix, linted, shown)
    for fix in ignore_comments(linted.session.tree, [finding], REASON):
        yield quick_fix(f"{fix.title} with a reason", fix, linted, shown)


def quick_fix(
    title: str, fix: Fix, linted: Linted, shown: Sequence[types.Diagnostic], *, is_preferred: bool | None = None
) -> types.CodeAction:
    return types.CodeAction(
        title,
        kind=types.CodeActionKind.QuickFix,
        diagnostics=shown,
        is_preferred=is_preferred,
        edit=workspace_edit(fix.operations, linted),
    )


def all_fixes(linted: Linted, path: Path) -> types.WorkspaceEdit:
    """Return all safe fixes of warnings and errors in the package of a file, as `rospkg lint --fix` makes them."""
    session = linted.session
    folder = package_of(path, linted.root, session.scope.folders)
    scope = replace(session.scope, selected=frozenset([] if folder is None else [folder]))
    found = fix_all(replace(session, scope=scope, kept=None), (Safety.SAFE,), Severity.WARNING)
    return edit_of_changes(found.changes, linted)
