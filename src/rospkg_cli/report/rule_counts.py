"""How many findings each rule has: a table for long reports, a line for the infos that are not shown."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

from ..finding import Finding, Severity
from ..light_dataclasses import dataclass
from .color import SEVERITY_COLORS, paint

HEAD = "error  warning  info  --fix  rule"
COLUMNS = ((Severity.ERROR, 5), (Severity.WARNING, 9), (Severity.INFO, 6))
"""The levels with the widths of their columns, blanks before them included."""


@dataclass(frozen=True)
class RuleCount:
    code: str
    name: str
    levels: Counter[Severity]
    fixable: int
    """With --fix alone."""

    @property
    def total(self) -> int:
        return sum(self.levels.values())

    @property
    def weight(self) -> tuple[int, int, int, str]:
        """Sorts rules, the worst last."""
        error, warning, info = (self.levels[level] for level in reversed(Severity))
        return error, warning, info, self.code


def rule_counts(findings: Iterable[Finding]) -> list[RuleCount]:
    """Return the counts of each rule that has findings, the worst last."""
    levels: dict[tuple[str, str], Counter[Severity]] = {}
    fixable: Counter[str] = Counter()
    for finding in findings:
        levels.setdefault((finding.code, finding.name), Counter())[finding.severity] += 1
        fixable[finding.code] += finding.fix_options == "--fix"
    counts = [RuleCount(code, name, found, fixable[code]) for (code, name), found in levels.items()]
    return sorted(counts, key=lambda count: count.weight)


def table(counts: Sequence[RuleCount], width: int | None, color: bool) -> list[str]:
    """Return the table, with a line of headings; names are cut where the width is short."""
    lines = [paint(HEAD[:width], "dim", color)]
    for count in counts:
        cells = "".join(
            " " * (columns - len(text)) + paint(text, SEVERITY_COLORS[level], color)
            for level, columns in COLUMNS
            if (text := str(count.levels[level] or "")) or True
        )
        rule = f"{count.code} {count.name}"
        room = None if width is None else max(width - HEAD.index("rule"), len(count.code))
        lines.append(f"{cells}{count.fixable or '':>7}  {rule if room is None else cut(rule, room)}")
    return lines


def cut(text: str, room: int) -> str:
    return text if len(text) <= room else text[: room - 1] + "…"
