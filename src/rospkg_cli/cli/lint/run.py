"""`rospkg lint`: find the packages, run the rules, fix, report."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import IO

from ...cache.kept_run import run_to_keep
from ...config.file import Config
from ...current_folder import absolute, current_folder
from ...disk_trace import stop_trace
from ...engine.discovery.choose_configs import choose_configs
from ...engine.discovery.locate import Located
from ...engine.fixing.fix_results import FixResults
from ...engine.run.results import Results
from ...engine.run.session import Session
from ...light_dataclasses import replace
from ...report import Report
from ...report.color import wants_color
from ...report.shared_infos import with_shared_infos
from ...report.wrap import terminal_width
from ..index.age import warn_of_age
from ..progress import progress
from ..streams import said, say
from .fixes import run_session, show_diff, write_fixes
from .kept_output import KeptOutput, may_be_kept
from .kept_packages import kept_packages
from .levels import asks_for_info, exit_status, least_failing, least_fixed
from .lint_options import LintOptions
from .located_packages import located_packages
from .print_report import print_report, report_files
from .result_filter import save_baseline
from .session import make_session


def lint(options: LintOptions) -> int:
    """Lint and report to stdout; return the exit status. Raises as lint_to does."""
    if options.watch:
        from .watch import watch

        return watch(options, lint_to)
    run = run_to_keep()
    if run is None or not may_be_kept(options):
        return lint_to(options, sys.stdout)
    shown, before = KeptOutput(sys.stdout), len(said)
    status = lint_to(options, shown)
    if len(said) == before:
        run.text = shown.text()
    return status


def lint_to(options: LintOptions, stream: IO[str]) -> int:
    """Lint and report to a stream; return the exit status.

    Raises UsageError, ConfigError, LocateError, PluginError, BaselineError and WriteError, each with one sentence.
    """
    fixing, suppression = options.fixing, options.suppression
    files = report_files(options.report.output)
    paths = options.paths or (Path(),)
    configs = choose_configs(paths, options.config, options.isolated)
    config, located = configs.root, located_packages(paths, options, configs)
    if options.show_settings:
        from .show_settings import show_settings

        return show_settings(options, configs, located, stream)
    with progress(not options.report.quiet) as show_progress:
        session = make_session(options, configs, located, show_progress)
        session = replace(session, kept=kept_packages(options, session))
        if options.stdin_filename is not None and located.scope.selected:
            from .standard_input import with_standard_input

            session = with_standard_input(session, located.root, options.stdin_filename)
        found = (
            run_session(session, fixing, least_fixed(options, config))
            if located.scope.selected
            else nothing_found(session, options, located)
        )
    for finding, why in found.refused:
        say(f"the fix of {finding.code} in {finding.location.path} was not made: {why}")
    report = make_report(options, config, located, found, stream)
    if fixing.diff and located.scope.selected:
        return show_diff(session, found, options)
    if fixing.fix or fixing.fix_only:
        write_fixes(session, found, located)
    if suppression.write_baseline and located.scope.selected:
        return save_baseline(suppression.write_baseline, report)
    if suppression.add_ignores is not None and located.scope.selected:
        from .add_ignores import add_ignores

        return add_ignores(suppression.add_ignores, session, report)
    if found.results.crashes:
        stop_trace()  # what crashed may not crash again
    print_report(options, replace(report, results=once_each(found.results)), files, stream, found.applied)
    warn_of_age(session.scope.index, found.results.findings)
    changed = bool(found.changes) and fixing.exit_non_zero_on_fix and not options.exit_zero
    return exit_status(found.results, least_failing(options, config), changed)


def make_report(options: LintOptions, config: Config, located: Located, found: FixResults, stream: IO[str]) -> Report:
    """Return the report for a stream."""
    shows_all = "all" in options.report.show
    return Report(
        found.results,
        located.root,
        current_folder(),
        wants_color(options.report.color, stream),
        len(found.applied),
        found.uncovered,
        terminal_width(stream),
        shows_info=shows_all or asks_for_info(options, config),
        shows_all=shows_all,
    )


def nothing_found(session: Session, options: LintOptions, located: Located) -> FixResults:
    """Return the results where there is no package to lint."""
    paths = options.paths or (Path(),)
    if options.stdin_filename is not None:
        return FixResults(Results())  # an editor gives every file of a kind
    if options.allow_empty or ((options.changed or options.since is not None) and located.scope.folders):
        return FixResults(Results())
    place = Path(os.path.relpath(absolute(paths[0]), located.root)).as_posix()
    return FixResults(session.no_packages([str(path) for path in paths], located.hidden, place))


def once_each(results: Results) -> Results:
    """Return the results to be shown; baselines and ignore comments are made of all findings."""
    return replace(results, findings=with_shared_infos(results.findings))
