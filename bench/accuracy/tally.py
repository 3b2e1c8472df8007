"""What two judges said: a finding is right only where both say so.

A verdict is a line of JSON, `{"id": 7, "verdict": "right", "why": "…"}`; the verdicts are:

right: true, and worth its level; loud: true, but a lower level fits; disputed: true by the letter, and most
maintainers would reject it; wrong: false; unknown: can't be said from what is at hand.
"""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

from bench.accuracy.sheet import read_lines

VERDICTS = ("right", "loud", "disputed", "wrong", "unknown", "differ")
ROW = "{:18}" + " {:>8}" * (len(VERDICTS) + 1)


def tally(findings: list[dict[str, Any]], first: Path, second: Path) -> str:
    """Return a table by level and code of both judges' verdicts, and where they differ.

    Raises:
        ValueError: a judge left a finding out, or said what is no verdict.
    """
    one, two = verdicts(first, findings), verdicts(second, findings)
    totals: Counter[tuple[str, str]] = Counter()
    for finding in findings:
        said = one[finding["id"]] if one[finding["id"]] == two[finding["id"]] else "differ"
        for group in ("all", finding["level"], f"{finding['level']} {finding['code']}"):
            totals[group, said] += 1
    lines = [ROW.format("", *VERDICTS, "sum")]
    for group in sorted({group for group, _ in totals}, key=lambda group: (group.count(" "), group)):
        numbers = [totals[group, verdict] for verdict in VERDICTS]
        lines.append(ROW.format(group, *numbers, sum(numbers)))
    return "\n".join(lines)


def verdicts(path: Path, findings: list[dict[str, Any]]) -> dict[int, str]:
    said = {int(row["id"]): str(row["verdict"]) for row in read_lines(path)}
    missing = [finding["id"] for finding in findings if said.get(finding["id"]) not in VERDICTS[:-1]]
    if missing:
        raise ValueError(f"{path}: no verdict on {', '.join(map(str, missing))}")
    return said
