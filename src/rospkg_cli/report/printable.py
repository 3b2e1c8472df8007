"""Findings whose texts can be printed."""

from __future__ import annotations

from ..control_characters import visible, visible_lines
from ..finding import Finding
from ..light_dataclasses import replace


def printable(finding: Finding) -> Finding:
    """Return a finding whose message, package and fix hold nothing that a terminal or a log would obey.

    Line ends and tabs in messages stay. Paths stay, for `Report.path` shows them; so does the excerpt, in which
    columns count.
    """
    message, package = visible_lines(finding.message), visible(finding.package)
    related = tuple((place, visible_lines(why)) for place, why in finding.related)
    title = visible_lines(finding.fix.title) if finding.fix else ""
    if (message, package, related) == (finding.message, finding.package, finding.related) and (
        finding.fix is None or title == finding.fix.title
    ):
        return finding
    fix = replace(finding.fix, title=title) if finding.fix else None
    return replace(finding, message=message, package=package, related=related, fix=fix)
