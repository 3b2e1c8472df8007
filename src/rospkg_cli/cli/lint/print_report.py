"""Print the report, and write the reports of --output."""

from __future__ import annotations

import io
import sys
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import IO

from ...control_characters import visible_lines, without_workflow_commands
from ...engine.fixing.write import write_text
from ...finding import Safety
from ...light_dataclasses import replace
from ...report import FORMATS, Report, render
from .. import UsageError
from .lint_options import ReportOptions


def report_files(typed: Sequence[str]) -> list[tuple[str, Path]]:
    """Return the format and the file of each --output; raises UsageError."""
    found = []
    for text in typed:
        name, _, path = text.partition(":")
        if name not in FORMATS or not path:
            raise UsageError(f"--output requires FORMAT:FILE with a format of {', '.join(FORMATS)}; not `{text}`")
        found.append((name, Path(path)))
    return found


def print_report(options: ReportOptions, report: Report, files: Sequence[tuple[str, Path]], stream: IO[str]) -> None:
    """Write the reports to their files, and one to a stream; raises WriteError."""
    for name, path in files:
        text = io.StringIO()
        render(name, replace(report, color=False), text)
        write_text(path, text.getvalue())
    if options.statistics:
        stream.write(statistics(report))
    elif not (options.quiet and options.format == "text" and not report.results.findings):
        render(options.format, report, stream)
    if options.traceback:
        for crash in report.results.crashes:
            print(without_workflow_commands(visible_lines(crash.error)), file=sys.stderr)


def statistics(report: Report) -> str:
    """Return the number of findings of each rule, the most frequent first."""
    findings = report.results.findings
    counts = Counter((finding.code, finding.name) for finding in findings)
    fixable = Counter(f.code for f in findings if f.fix and f.fix.safety is Safety.SAFE)
    lines = [
        f"{count:>6}  {code}  {name}" + (f"  ({fixable[code]} fixable with --fix)" if fixable[code] else "")
        for (code, name), count in sorted(counts.items(), key=lambda each: (-each[1], each[0]))
    ]
    return "".join(f"{line}\n" for line in lines) + f"{len(findings):>6}  in {report.results.packages} packages\n"
