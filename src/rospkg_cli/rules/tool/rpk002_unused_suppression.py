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
    Finds ignore comments, and ignores of the config, that silence nothing. Only rules that ran are judged: with
    `--select SET`, an ignored XML104 says nothing.

    ## Why is this bad?
    The fault was mended and its excuse stayed: the next fault of that kind would be hidden by it.
    """
    fix = None
    if unused.delete:
        fix = Fix(f"Remove the ignore of {unused.code}", (Edit(unused.path, unused.delete, ""),))
    message = f"`{unused.code}` is ignored here, but nothing here breaks it; remove the ignore"
    yield Hit(unused.path, unused.span, message, fix=fix)
