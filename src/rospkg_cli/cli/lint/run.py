"""`rospkg lint`: locate, run, judge, fix, report."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import IO

from ...config.file import Config, find_config
from ...current_folder import absolute, here
from ...engine.baseline import apply_baseline, read_baseline, write_baseline
from ...engine.config_filter import ConfigFilter
from ...engine.discovery.locate import Located, locate
from ...engine.fixing.fix import FixResults, fix_all
from ...engine.fixing.remove_leftovers import remove_leftovers
from ...engine.fixing.write import write_changes, write_text
from ...engine.run.session import Results, Session
from ...fence import Fence
from ...finding import Safety, Severity
from ...report import Report
from ...report.color import wants_color
from ..diff import unified
from ..index.age import warn_of_age
from ..progress import progress
from ..streams import say
from .add_ignores import add_ignores
from .print_report import print_report
from .session import LintOptions, make_session, outputs


def lint(options: LintOptions) -> int:
    """Lint and report to stdout; return the exit status. Raises as lint_to does."""
    return lint_to(options, sys.stdout)


def lint_to(options: LintOptions, stream: IO[str]) -> int:
    """Lint and report to a stream; return the exit status.

    Raises UsageError, ConfigError, LocateError, PluginError, BaselineError and WriteError, each with one sentence.
    """
    files = outputs(options)
    paths = options.paths or (Path(),)
    config = find_config(nearest_folder(paths))
    located = locate(paths, options.workspace, config)
    session = make_session(options, config, located)
    session.judge = result_filter(options, config, located)
    outcome = run(options, session, located)
    report = Report(
        outcome.results,
        located.root,
        here(),
        wants_color(options.color, stream),
        options.verbose,
        0 if options.diff else len(outcome.applied),
    )
    if options.diff:
        stream.writelines(unified(session.tree, outcome.changes))
    elif options.fix:
        remove_leftovers(located.root / folder for folder in located.scope.given)
        write_changes(located.root, session.tree, outcome.changes, Fence(located.root, located.scope.folders))
    checked = bool(located.scope.given)
    if options.write_baseline and checked:
        return save_baseline(options.write_baseline, report)
    if options.add_ignores is not None and checked:
        return add_ignores(options.add_ignores, session, report)
    print_report(options, report, files, stream)
    warn_of_age(session.scope.index, outcome.results.findings)
    return exit_status(options, config, report, outcome)


def nearest_folder(paths: Sequence[Path]) -> Path:
    common = Path(os.path.commonpath([absolute(p) for p in paths]))
    return common if common.is_dir() else common.parent


def result_filter(options: LintOptions, config: Config, located: Located) -> Callable[[Session, Results], Results]:
    """Return what sets findings aside: the config, then the baseline."""
    judge = ConfigFilter(config, located.root, located.scope.given == frozenset(located.scope.folders))
    if options.baseline is None:
        return judge
    known, shown = read_baseline(options.baseline), relative_to(options.baseline, located.root)
    return lambda session, results: apply_baseline(judge(session, results), known, shown)


def relative_to(baseline: Path, root: Path) -> Callable[[str], str]:
    folder = absolute(baseline).parent
    return lambda path: Path(os.path.relpath(root / path, folder)).as_posix()


def run(options: LintOptions, session: Session, located: Located) -> FixResults:
    if not located.scope.given:
        shown = [str(path) for path in options.paths or (Path(),)]
        return FixResults(Results() if options.allow_empty else session.nothing(shown, located.hidden))
    with progress(not options.quiet) as session.phase:
        if not (options.fix or options.diff):
            return FixResults(session.run())
        outcome = fix_all(session, (Safety.SAFE, Safety.UNSAFE) if options.unsafe_fixes else (Safety.SAFE,))
    for finding, why in outcome.refused:
        say(f"the fix of {finding.code} in {finding.place.path} was taken back: {why}")
    return outcome


def save_baseline(path: Path, report: Report) -> int:
    """Write the baseline; return the exit status."""
    findings = report.results.findings
    write_text(path, write_baseline(findings, relative_to(path, report.root)))
    say(f"{len(findings)} findings are in `{path}`; lint with --baseline {path}")
    return 0


def exit_status(options: LintOptions, config: Config, report: Report, outcome: FixResults) -> int:
    """Return 3 after a fault of ours, 2 where nothing was checked, 1 where findings remain or a fix says so, else 0."""
    results = report.results
    codes = {finding.code for finding in results.findings}
    if results.crashes:
        return 3
    if "RPK006" in codes:
        return 2
    least = Severity(options.fail_on or config.fail_on).rank
    failing = any(finding.severity.rank >= least for finding in results.findings)
    changed = bool(outcome.changes) and (options.diff or options.exit_non_zero_on_fix)
    return 1 if failing or changed else 0
