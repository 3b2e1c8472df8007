"""Print the report, and write the reports of --output."""

from __future__ import annotations

import io
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import IO

from ...control_characters import visible_lines, without_workflow_commands
from ...finding import Finding
from ...light_dataclasses import replace
from ...report import FORMATS, Report, render
from .. import UsageError
from .lint_options import LintOptions

NOTES = "RPK008"
"""The rule whose findings are notes on the run."""

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
    if fixed and ((is_text and not shown.quiet) or options.fixing.show_fixes):
        from .fix_list import fix_list

        print_lines(fix_list(report, fixed, options.fixing.show_fixes), stream if is_text else sys.stderr)
    if options.fixing.fix_only:
        report = only_of_the_run(report)
    elif is_text and fixed and not shown.quiet:
        stream.write("\n")
    is_silent = options.fixing.fix_only or (shown.quiet and is_text)
    if shown.statistics:
        from .statistics import print_statistics

        print_statistics(report, shown.format, stream)
    elif not is_silent or any(finding.code != NOTES for finding in report.results.findings):
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
