"""`--statistics`: how many findings each rule has."""

from __future__ import annotations

from typing import IO, Any

from ...finding import Severity
from ...report import Report
from ...report.dump import dump
from ...report.rule_counts import RuleCount, rule_counts


def print_statistics(report: Report, format: str, stream: IO[str]) -> None:
    """Print the counts as text or as JSON."""
    if format == "json":
        dump(statistics_document(report), stream)
    else:
        stream.write(statistics(report))


def statistics(report: Report) -> str:
    """Return the number of findings of each rule, the most frequent first."""
    lines = [
        f"{count.total:>6}  {count.code}  {count.name}"
        + (f"  ({count.fixable} fixable with --fix)" if count.fixable else "")
        for count in most_frequent(report)
    ]
    total = f"{len(report.results.findings):>6}  in {report.results.packages} packages\n"
    return "".join(f"{line}\n" for line in lines) + total


def statistics_document(report: Report) -> list[dict[str, Any]]:
    """Return the same as plain values for JSON, with the counts of each level."""
    return [
        {
            "code": count.code,
            "name": count.name,
            "count": count.total,
            **{f"{level.value}s": count.levels[level] for level in reversed(Severity)},
            "fixable": count.fixable,
        }
        for count in most_frequent(report)
    ]


def most_frequent(report: Report) -> list[RuleCount]:
    return sorted(rule_counts(report.results.findings), key=lambda count: (-count.total, count.code))
