"""`rospkg lint`: find the packages, run the rules, fix, report."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import IO

from ...cache.kept_run import run_to_keep
from ...config.file import Config
from ...config.hierarchy import ConfigTree
from ...current_folder import absolute, current_folder
from ...disk_trace import exists, stop_trace
from ...engine.discovery.choose_configs import choose_configs
from ...engine.discovery.locate import Located, locate
from ...engine.fixing.fix_results import FixResults
from ...engine.run.results import Results
from ...engine.run.session import Session
from ...engine.selection import codes_named, rule_names
from ...fence import Fence
from ...finding import Safety, Severity
from ...light_dataclasses import replace
from ...report import Report
from ...report.color import wants_color
from ...report.summary import counted
from ...report.told_once import told_once
from ...report.wrap import terminal_width
from .. import UsageError
from ..index.age import warn_of_age
from ..progress import progress
from ..streams import said, say
from .kept_output import KeptOutput, may_be_kept
from .kept_packages import kept_packages
from .lint_options import FixOptions, LintOptions
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


def once_each(results: Results) -> Results:
    """Return the results to be shown; baselines and ignore comments are made of all findings."""
    return replace(results, findings=told_once(results.findings))


def located_packages(paths: Sequence[Path], options: LintOptions, configs: ConfigTree) -> Located:
    """Find the packages; raises LocateError, and UsageError for a rule that stands where a path belongs."""
    for path in paths:
        if not exists(path) and codes_named(str(path)):
            raise UsageError(f"`{path}` is a rule, and stands where a path belongs; join rules by commas: --select A,B")
    located = locate(paths, options.workspace, configs)
    return changed_alone(located, options.since or "") if options.changed or options.since is not None else located


def changed_alone(located: Located, since: str) -> Located:
    """Return the packages without those that git sees no change in; raises GitError."""
    from .changed_packages import changed_packages

    folders = {located.root / folder: folder for folder in located.scope.selected}
    changed = changed_packages(sorted(folders), since)
    selected = frozenset(folder for path, folder in folders.items() if path in changed)
    return replace(located, scope=replace(located.scope, selected=selected))


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


def show_diff(session: Session, found: FixResults, options: LintOptions) -> int:
    """Print what the fixes would change and, on stderr, how many there are; return the exit status."""
    from ..diff import unified

    sys.stdout.writelines(unified(session.tree, found.changes))
    count, files = counted(len(found.applied), "finding"), counted(len(found.changes), "file")
    how = "--fix --unsafe-fixes" if options.fixing.unsafe_fixes else "--fix"
    say(f"{how} would fix {count} in {files}" if found.changes else f"{how} would change nothing")
    if found.results.crashes:
        return 3
    return 1 if found.changes and not options.exit_zero else 0


def least_failing(options: LintOptions, config: Config) -> Severity | None:
    """Return the least level that fails; None where none does."""
    if options.exit_zero or options.fixing.fix_only:
        return None
    return Severity(options.fail_on or config.fail_on)


def asks_for_info(options: LintOptions, config: Config) -> bool:
    """Return whether the text shows infos: asked for, or the reason of a failure, or what a rule was named for."""
    fails = (options.fail_on or config.fail_on) == Severity.INFO.value
    return "info" in options.report.show or fails or not set(options.rules.select).isdisjoint(rule_names())


def least_fixed(options: LintOptions, config: Config) -> Severity:
    """Return the least severity that is fixed: infos are left alone where no option asks for them."""
    are_shown = "all" in options.report.show or asks_for_info(options, config)
    default = Severity.INFO if are_shown else Severity.WARNING
    return Severity(options.fixing.fix_level) if options.fixing.fix_level else default


def run_session(session: Session, options: FixOptions, level: Severity) -> FixResults:
    """Lint, and fix in memory where that is asked for."""
    if not (options.fix or options.fix_only or options.diff):
        return FixResults(session.run())
    from ...engine.fixing.fix import fix_all

    return fix_all(session, (Safety.SAFE, Safety.UNSAFE) if options.unsafe_fixes else (Safety.SAFE,), level)


def nothing_found(session: Session, options: LintOptions, located: Located) -> FixResults:
    """Return the results where there is no package to lint."""
    paths = options.paths or (Path(),)
    if options.stdin_filename is not None:
        return FixResults(Results())  # an editor gives every file of a kind
    if options.allow_empty or ((options.changed or options.since is not None) and located.scope.folders):
        return FixResults(Results())
    place = Path(os.path.relpath(absolute(paths[0]), located.root)).as_posix()
    return FixResults(session.no_packages([str(path) for path in paths], located.hidden, place))


def write_fixes(session: Session, found: FixResults, located: Located) -> None:
    """Write what was fixed; raises WriteError."""
    from ...engine.fixing.remove_leftovers import remove_leftovers
    from ...engine.fixing.write import write_changes

    remove_leftovers(located.root / folder for folder in located.scope.selected)
    write_changes(located.root, session.tree, found.changes, Fence(located.root, located.scope.folders))


def exit_status(results: Results, fail_on: Severity | None, changed: bool) -> int:
    """Return 3 after an internal error, 2 where nothing was checked, 1 for findings or changes that fail, else 0."""
    if results.crashes:
        return 3
    if any(finding.code == "RPK006" for finding in results.findings):
        return 2
    judged = (finding for finding in results.findings if finding.code != "RPK008")
    fails = fail_on and any(finding.severity.rank >= fail_on.rank for finding in judged)
    return 1 if changed or fails else 0
