"""RPK009 ignore-without-reason."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import Example, manifest
from ...finding import Hit, Severity
from ...package.run_events import ReasonlessIgnore
from ...rule import rule

BAD = manifest("  <!-- rospkg: ignore[«XML209»] -->\n  <depend>rclpy</depend>\n")
GOOD = BAD.replace("] -->", "] the template writes it so -->").replace("«", "").replace("»", "")


@rule(
    "RPK009",
    "ignore-without-reason",
    over=ReasonlessIgnore,
    severity=Severity.WARNING,
    examples=(Example(bad={"package.xml": BAD}, good={"package.xml": GOOD}),),
)
def ignore_without_reason(ignore: ReasonlessIgnore) -> Iterator[Hit]:
    """
    ## What it does
    Finds ignore comments that suppress a finding and do not say why.
    The finding is suppressed all the same. In the config a reason is demanded: an ignore without one is an error there.

    ## Why is this bad?
    No one knows later whether the ignore is still needed, so it stays for ever.

    ## When it is quiet
    Any text after the bracket is a reason.
    """
    yield Hit(ignore.path, ignore.span, f"the ignore of `{ignore.codes}` gives no reason; write one after the bracket")
