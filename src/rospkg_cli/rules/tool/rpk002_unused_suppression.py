"""RPK002 unused-suppression."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import Example, manifest
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...package.run_events import UnusedSuppression
from ...rule import rule

IGNORE = "  <!-- rospkg: ignore[«XML104»] the text will come -->\n"


@rule(
    "RPK002",
    "unused-suppression",
    over=UnusedSuppression,
    severity=Severity.WARNING,
    examples=(Example(bad={"package.xml": manifest(IGNORE)}, good={"package.xml": manifest()}, fix=Safety.SAFE),),
)
def unused_suppression(unused: UnusedSuppression) -> Iterator[Hit]:
    """
    ## What it does
    Finds ignore comments, and ignores of the config, that suppress nothing.
    An ignore of a rule that did not run is not reported. A pattern of the config's `exclude` that fits nothing is, in a
    run over the whole workspace.

    ## Why is this bad?
    The problem was fixed and the ignore stayed: it would hide the next problem of that kind.

    ## When it is quiet
    Only rules that ran are considered: with `--select SET`, an unused ignore of XML104 is not reported.
    """
    fix = None
    if unused.delete:
        fix = Fix(f"Remove the ignore of {unused.code}", (Edit(unused.path, unused.delete, ""),))
    message = f"nothing here is reported as `{unused.code}`: this ignore would hide the next one; remove it"
    if unused.is_pattern:
        message = f"`{unused.code}` fits no folder and no file: it excludes nothing; correct or remove it"
    yield Hit(unused.path, unused.span, message, fix=fix)
