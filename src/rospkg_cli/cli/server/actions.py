"""What an editor offers at a finding: its fix, an ignore with a reason; and all safe fixes of a package."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from itertools import count
from pathlib import Path

from lsprotocol import types

from ...engine.fixing.fix import fix_all
from ...engine.live.noting_pool import NotingPool
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
FIX_ALL_COMMAND = "rospkg.fixAll"
SAFETY, LEAST = Safety.SAFE, Severity.WARNING
"""What is fixed by it, as by `rospkg lint --fix`."""

REASON = "say here why"
"""What stands for the reason of an ignore until somebody writes it."""


KEYS = count(1)
"""What distinguishes the actions that fix all."""


def actions(linted: Linted, path: Path, asked: types.CodeActionParams) -> Iterator[types.CodeAction]:
    """Yield what can be done at a range of a file."""
    only = asked.context.only
    for finding in linted.by_file.get(path, []):
        at = to_range(linted.codec, linted.source(finding.location.path), finding.location)
        if is_wanted(types.CodeActionKind.QuickFix, only) and touch(at, asked.range):
            yield from fixes(linted, finding)
    if is_wanted(FIX_ALL, only) and (found := linted.by_file.get(path)) and has_safe_fix(linted, found[0].package):
        yield fix_all_action(found[0].package, path)


def has_safe_fix(linted: Linted, package: str) -> bool:
    """Return whether fixing all in a package fixes anything."""
    own = [each for each in linted.findings if each.package == package and each.severity.rank >= LEAST.rank]
    return any(each.fix is not None and each.fix.safety is SAFETY for each in own)


def fix_all_action(package: str, path: Path) -> types.CodeAction:
    """Return the action whose edit is made when it is chosen, or by its command where it is not ready by then."""
    title, key = f"rospkg: fix all in {package}", str(next(KEYS))
    command = types.Command(title, FIX_ALL_COMMAND, arguments=[key, str(path)])
    return types.CodeAction(title, kind=FIX_ALL, data={"key": key, "path": str(path)}, command=command)


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
    """Return all safe fixes of warnings and errors in the package of a file, as `rospkg lint --fix` makes them.

    Raises RunInterrupted as soon as one of the texts changes.
    """
    session = linted.session
    folder = package_of(path, linted.root, session.scope.folders)
    scope = replace(session.scope, selected=frozenset([] if folder is None else [folder]))
    pool = partial(NotingPool, look=linted.run.order.look)
    session = replace(session, scope=scope, kept=None, make_pool=pool, make_small_pool=pool)
    found = fix_all(session, (SAFETY,), LEAST)
    return edit_of_changes(found.changes, linted)
