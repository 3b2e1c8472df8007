"""`rospkg upgrade`: show or write what a newer distribution asks for, and list what is left."""

from __future__ import annotations

import os
import sys
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from ...change.git_state import require_clean
from ...control_characters import visible
from ...current_folder import current_folder
from ...engine.discovery.choose_configs import choose_configs
from ...engine.discovery.locate import Located, locate
from ...engine.fixing.target_fixes import TargetFixes, target_fixes
from ...engine.fixing.write import write_changes
from ...fence import Fence
from ...finding import Finding
from ...report.summary import counted
from ...ros.distros import DISTROS, fault_of_name
from .. import UsageError
from ..change.finish import guarded_change
from ..lint.lint_options import LintOptions
from ..lint.session import make_session
from ..streams import say


def upgrade(paths: Sequence[Path], to: str, write: bool = False, allow_dirty: bool = False) -> int:
    """Fix what a distribution makes wrong; return 0, or 1 where something is left to do or was only shown.

    Raises UsageError, LocateError and ConfigError.
    """
    if not to:
        raise UsageError(f"name the distribution to move to: --to {DISTROS[-2].name}")
    if fault := fault_of_name(to):
        raise UsageError(fault)
    if to == DISTROS[0].name:
        raise UsageError(f"{to} is the oldest distribution that is known here; there is nothing to move from")
    return guarded_change(lambda: upgraded(paths, to, write, allow_dirty))


def upgraded(paths: Sequence[Path], to: str, write: bool, allow_dirty: bool) -> int:
    configs = choose_configs(paths)
    located = locate(paths, None, configs)
    if not located.scope.selected:
        raise UsageError(f"there is no package at {', '.join(f'`{path}`' for path in paths)}; give the path of one")
    session = make_session(LintOptions(paths=tuple(paths)), configs, located, lambda _: None)
    done = target_fixes(session, to)
    changes = done.fixes.changes
    if write and changes:
        if not allow_dirty:
            for folder, inside in by_repository(located, changes).items():
                require_clean(folder, inside)
        write_changes(located.root, session.tree, changes, Fence(located.root, located.scope.folders))
    elif changes:
        from ..diff import unified

        sys.stdout.writelines(unified(session.tree, changes))
    for line in summary(done, to, write, located.root):
        say(line)
    return 1 if done.left or (changes and not write) else 0


def by_repository(located: Located, changes: Iterable[str]) -> dict[Path, list[str]]:
    """Return the changed files by the package that holds them, relative to it: each may be in a repository."""
    found: dict[Path, list[str]] = {}
    for path in changes:
        folders = [each for each in located.scope.folders if not each or path.startswith(f"{each}/")]
        folder = max(folders, key=len, default="")
        found.setdefault(located.root / folder, []).append(path[len(folder) + 1 :] if folder else path)
    return found


def summary(done: TargetFixes, to: str, written: bool, root: Path) -> Iterator[str]:
    """Yield what was fixed, by rule, and what is left to a person, with the place and the reason."""
    if not done.found:
        yield f"nothing here is wrong for {to} that was right before"
        return
    fixed = len(done.found) - len(done.left)
    files = counted(len(done.fixes.changes), "file")
    verb = "fixed" if written else "would be fixed"
    yield f"{to}: {fixed} of {counted(len(done.found), 'finding')} {verb}, in {files}{by_rule(done)}"
    if done.left:
        yield f"left to do by hand: {len(done.left)}"
    here = current_folder()
    for each in done.left:
        path = visible(Path(os.path.relpath(root / each.location.path, here)).as_posix())
        yield f"  {path}:{each.location.line}: {each.code} {visible(each.message)}"
    if done.fixes.changes and not written:
        yield "nothing was written; --write writes it"


def by_rule(done: TargetFixes) -> str:
    """Return how often each rule was fixed: ` (CMK005 3, SET304 1)`."""
    left = Counter(map(code_of, done.left))
    counts = {code: n - left[code] for code, n in Counter(map(code_of, done.found)).items() if n > left[code]}
    return f" ({', '.join(f'{code} {n}' for code, n in sorted(counts.items()))})" if counts else ""


def code_of(finding: Finding) -> str:
    return finding.code
