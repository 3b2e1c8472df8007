"""What `rospkg lint` fixes: in memory first, then shown as a diff or written."""

from __future__ import annotations

import sys

from ...engine.discovery.locate import Located
from ...engine.fixing.fix_results import FixResults
from ...engine.run.session import Session
from ...fence import Fence
from ...finding import Safety, Severity
from ...report.summary import counted
from ..streams import say
from .lint_options import FixOptions, LintOptions


def run_session(session: Session, options: FixOptions, level: Severity) -> FixResults:
    """Lint, and fix in memory where that is asked for."""
    if not (options.fix or options.fix_only or options.diff):
        return FixResults(session.run())
    from ...engine.fixing.fix import fix_all

    return fix_all(session, (Safety.SAFE, Safety.UNSAFE) if options.unsafe_fixes else (Safety.SAFE,), level)


def show_diff(session: Session, found: FixResults, options: LintOptions) -> int:
    """Print what the fixes would change and, on stderr, how many there are; return the exit status."""
    from ..diff import unified

    sys.stdout.writelines(unified(session.tree, found.changes))
    count, files = counted(len(found.applied), "finding"), counted(len(found.changes), "file")
    how = "--fix --unsafe-fixes" if options.fixing.unsafe_fixes else "--fix"
    say(f"{how} would fix {count} in {files}" if found.changes else f"{how} would change nothing")
    if found.results.crashes:
        return 3
    return 1 if found.changes and not options.exit_zero else 0


def write_fixes(session: Session, found: FixResults, located: Located) -> None:
    """Write what was fixed; raises WriteError."""
    from ...engine.fixing.remove_leftovers import remove_leftovers
    from ...engine.fixing.write import write_changes

    remove_leftovers(located.root / folder for folder in located.scope.selected)
    write_changes(located.root, session.tree, found.changes, Fence(located.root, located.scope.folders))
