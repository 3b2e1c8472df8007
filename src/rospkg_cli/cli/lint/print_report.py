"""Print the report, and write the reports of --output."""

from __future__ import annotations

import io
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import IO, Any

from ...control_characters import visible_lines, without_workflow_commands
from ...finding import Finding, Severity
from ...light_dataclasses import replace
from ...report import FORMATS, Report, render
from ...report.dump import dump
from ...report.rule_counts import RuleCount, rule_counts
from .. import UsageError
from .fix_list import fix_list
from .lint_options import LintOptions

FAILURES = frozenset({"RPK005", "RPK006"})
"""The rules that report a run that failed."""


def report_files(typed: Sequence[str]) -> list[tuple[str, Path]]:
    """Return the format and the file of each --output; raises UsageError."""
    found = []
    for text in typed:
        name, _, path = text.partition(":")
        if name not in FORMATS or not path:
            raise UsageError(f"--output requires FORMAT:FILE with a format of {', '.join(FORMATS)}; not `{text}`")
        found.append((name, Path(path)))
    return found


def print_report(
    options: LintOptions, report: Report, files: Sequence[tuple[str, Path]], stream: IO[str], fixed: Sequence[Finding]
) -> None:
    """Write the reports to their files, and one with the fixes before it to a stream; raises WriteError."""
    shown, is_text = options.report, options.report.format == "text" and not options.report.statistics
    for name, path in files:
        from ...engine.fixing.write import write_text

        text = io.StringIO()
        render(name, replace(report, color=False, width=None), text)
        write_text(path, text.getvalue())
    if (is_text and not shown.quiet) or options.fixing.show_fixes:
        print_lines(fix_list(report, fixed, options.fixing.show_fixes), stream if is_text else sys.stderr)
    if options.fixing.fix_only:
        report = only_of_the_run(report)
    elif is_text and fixed and not shown.quiet:
        stream.write("\n")
    is_silent = options.fixing.fix_only or (shown.quiet and is_text)
    if shown.statistics and shown.format == "json":
        dump(statistics_document(report), stream)
    elif shown.statistics:
        stream.write(statistics(report))
    elif report.results.findings or not is_silent:
        render(shown.format, report, stream)
    if shown.traceback:
        print_lines(
            [without_workflow_commands(visible_lines(each.error)) for each in report.results.crashes], sys.stderr
        )


def only_of_the_run(report: Report) -> Report:
    """Return the report with nothing but what went wrong with the run: a crash, or no package."""
    left = tuple(finding for finding in report.results.findings if finding.code in FAILURES)
    return replace(report, results=replace(report.results, findings=left))


def print_lines(lines: Sequence[str], stream: IO[str]) -> None:
    stream.writelines(f"{line}\n" for line in lines)


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
