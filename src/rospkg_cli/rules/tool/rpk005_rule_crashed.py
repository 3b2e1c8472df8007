"""RPK005 rule-crashed."""

from __future__ import annotations

from collections.abc import Iterator

from ...finding import Hit, Severity
from ...package.run_events import RuleCrash
from ...rule import rule
from ...source import Span


@rule("RPK005", "rule-crashed", over=RuleCrash, severity=Severity.ERROR, examples=())
def rule_crashed(crash: RuleCrash) -> Iterator[Hit]:
    """
    ## What it does
    Reports that a rule, a reader or a fix raised an exception on a package.
    The other rules and packages go on; the exit status is 3 after everything has been printed.

    ## Why is this bad?
    That rule did not check the package. This is an internal error of rospkg: please report it with the output of
    `--traceback`.

    ## When it is quiet
    It has no conditions: a rule that crashes is always reported.
    """
    last = crash.error.strip().splitlines()[-1]
    what = f"{crash.what} {crash.code}"
    yield Hit(crash.path, Span(0, 0), f"{what} failed on `{crash.package}`: {last}; please report this")
