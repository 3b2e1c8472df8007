"""RPK008 check-switched-off."""

from __future__ import annotations

from collections.abc import Iterator

from ...finding import Hit, Severity
from ...package.run_events import CheckSwitchedOff
from ...rule import rule

MOST = 3
"""Names that a message lists."""


@rule("RPK008", "check-switched-off", over=CheckSwitchedOff, severity=Severity.INFO, examples=())
def check_switched_off(off: CheckSwitchedOff) -> Iterator[Hit]:
    """
    ## What it does
    Reports that names of dependencies are not checked, and why, once in a run.
    A `.repos` or `.rosinstall` file lists repositories that are not checked out, a submodule is empty, or no index of
    names was fetched: a name that is not known here may exist elsewhere, and unknown-dependency (DEP001) is silent.
    Check the repositories out, or run `rospkg index update`. It never makes a run fail.

    ## Why is this bad?
    It isn't. But a misspelt dependency looks like one that is fine, and an empty report should not hide that.

    ## When it is quiet
    Where every name is known, in the workspace, in the names that are built in or in a fetched index, nothing is said.
    """
    names = ", ".join(f"`{name}`" for name in off.names[:MOST])
    more = len(off.names) - MOST
    others = f" and {more} other{'s' if more > 1 else ''}" if more > 0 else ""
    exist = "exists" if len(off.names) == 1 else "exist"
    yield Hit(off.path, off.span, f"whether {names}{others} {exist} is not checked: {off.why}")
