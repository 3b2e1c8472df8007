"""RPK003 unknown-rule."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import Example, manifest
from ...finding import Hit, Severity
from ...package.run_events import UnknownRuleName
from ...rule import rule

BAD = manifest("  <!-- rospkg: ignore[«placeholder-metdata»] the text will come -->\n")
BARE = manifest("  «<!-- rospkg: ignore the text will come -->»\n")
GOOD = manifest()


@rule(
    "RPK003",
    "unknown-rule",
    over=UnknownRuleName,
    severity=Severity.WARNING,
    examples=(
        Example(bad={"package.xml": BAD}, good={"package.xml": GOOD}),
        Example(bad={"package.xml": BARE}, good={"package.xml": GOOD}),
    ),
)
def unknown_rule(unknown: UnknownRuleName) -> Iterator[Hit]:
    """
    ## What it does
    Finds ignore comments that name no rule.
    They name neither a code (`SET101`), nor a name (`entry-point-module-missing`), nor the beginning of a code
    (`SET1`), or there is no bracket with names at all.

    ## Why is this bad?
    The ignore has no effect, without a warning.

    ## When it is quiet
    Codes and names of rules of plugins count where the config names the plugin.
    """
    if not unknown.name:
        message = "this comment names no rule, so it ignores nothing; write `rospkg: ignore[CODE] reason`"
        yield Hit(unknown.path, unknown.span, message)
        return
    hint = f"; did you mean `{unknown.nearest}`?" if unknown.nearest else "; `rospkg rules` lists them"
    yield Hit(unknown.path, unknown.span, f"there is no rule `{unknown.name}`, so this ignores nothing{hint}")
