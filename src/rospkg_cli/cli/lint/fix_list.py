"""What was fixed, as people read it: the file, the code and the title of each fix."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from ...control_characters import visible, without_workflow_commands
from ...finding import Finding
from ...report import Report
from ...report.short_message import lowered
from ...report.summary import counted

MOST = 10
"""Fixes that are listed unless all are asked for."""


def fix_list(report: Report, fixed: Sequence[Finding], every: bool) -> list[str]:
    """Return a line with the number of fixes, and one for each; of many only the first unless `every` is set."""
    if not fixed:
        return []
    rows = Counter(row(report, each) for each in fixed)
    listed = sorted(rows.items())
    shown = listed if every or len(listed) <= MOST + 1 else listed[:MOST]
    files = len({path for each in fixed for path in changed_paths(each)})
    lines = [f"Fixed {counted(len(fixed), 'finding')} in {counted(files, 'file')}:"]
    lines += [f"  {text}{f' (×{times})' if times > 1 else ''}" for text, times in shown]
    if len(shown) < len(listed):
        lines.append(f"  … and {counted(sum(times for _, times in listed[MOST:]), 'other')}; --show-fixes lists all")
    return [without_workflow_commands(line) for line in lines]


def row(report: Report, fixed: Finding) -> str:
    """Return the files that a fix changed, its code and its title."""
    title = visible(fixed.fix.title) if fixed.fix else ""
    return f"{', '.join(map(report.path, changed_paths(fixed)))}: {fixed.code} {lowered(title)}"


def changed_paths(fixed: Finding) -> list[str]:
    return sorted({operation.path for operation in fixed.fix.operations}) if fixed.fix else []
