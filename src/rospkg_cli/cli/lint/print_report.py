"""Print the report, and write those of --output."""

from __future__ import annotations

import io
import sys
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import IO

from ...control_characters import no_command, visible_lines
from ...engine.fixing.write import write_text
from ...finding import Safety
from ...report import Report, render
from .session import LintOptions


def print_report(options: LintOptions, report: Report, files: Sequence[tuple[str, Path]], stream: IO[str]) -> None:
    """Write every report that was asked for; raises WriteError."""
    for name, path in files:
        text = io.StringIO()
        render(name, replace(report, color=False), text)
        write_text(path, text.getvalue())
    to = sys.stderr if options.diff else stream
    if options.statistics:
        to.write(statistics(report))
    elif not (options.quiet and options.format == "text" and not report.results.findings):
        render(options.format, report, to)
    if options.verbose:
        for crash in report.results.crashes:
            print(no_command(visible_lines(crash.error)), file=sys.stderr)


def statistics(report: Report) -> str:
    """Return how often each rule was broken, the commonest first."""
    findings = report.results.findings
    counts = Counter((finding.code, finding.name) for finding in findings)
    fixable = Counter(f.code for f in findings if f.fix and f.fix.safety is Safety.SAFE)
    lines = [
        f"{count:>6}  {code}  {name}" + (f"  (--fix repairs {fixable[code]})" if fixable[code] else "")
        for (code, name), count in sorted(counts.items(), key=lambda each: (-each[1], each[0]))
    ]
    return "".join(f"{line}\n" for line in lines) + f"{len(findings):>6}  in {report.results.packages} packages\n"
