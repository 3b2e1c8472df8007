"""`rospkg lint`: locate, run, judge, fix, report."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import IO

from ..config import Config, find_config
from ..engine.fix import Repair, repair
from ..engine.judge import Judge
from ..engine.locate import Located, locate
from ..engine.pool import SERIAL_BELOW, ProcessPool
from ..engine.selection import Selection, codes_named, rule_names
from ..engine.session import Pool, Results, Session
from ..engine.write import write_changes
from ..finding import Safety, Severity
from ..model.settings import Settings
from ..report import FORMATS, Report, render
from ..report.style import wants_color
from ..ros.distros import DISTROS, Targets
from ..rule import Profile
from ..suggest import did_you_mean
from ..tree import DiskTree
from . import UsageError
from .diff import unified


@dataclass(frozen=True)
class LintOptions:
    """What was typed; None where nothing was."""

    paths: tuple[Path, ...] = ()
    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    extend_select: tuple[str, ...] = ()
    pedantic: bool = False
    release: bool = False
    target: tuple[str, ...] = ()
    fail_on: str | None = None
    fix: bool = False
    unsafe_fixes: bool = False
    diff: bool = False
    exit_non_zero_on_fix: bool = False
    format: str = "text"
    output: tuple[str, ...] = ()
    workspace: Path | None = None
    jobs: str = "auto"
    allow_empty: bool = False
    color: str = "auto"
    verbose: bool = False
    quiet: bool = False


def lint(options: LintOptions) -> int:
    """Lint and report; return the exit status. Raises UsageError, ConfigError, LocateError, WriteError."""
    outputs = [parse_output(text) for text in options.output]
    paths = options.paths or (Path(),)
    config = find_config(nearest_folder(paths))
    located = locate(paths, options.workspace, config)
    session = make_session(options, config, located)
    judge = Judge(config, located.root)
    outcome = run(options, session, judge, located)
    report = Report(
        with_config(outcome.results, session, judge, located),
        located.root,
        Path.cwd(),
        wants_color(options.color, sys.stdout),
        options.verbose,
        0 if options.diff else len(outcome.applied),
    )
    if options.diff:
        sys.stdout.writelines(unified(session.tree, outcome.changes))
    elif outcome.changes:
        write_changes(located.root, session.tree, outcome.changes)
    show(options, report, outputs)
    return status(options, config, report, outcome)


def nearest_folder(paths: Sequence[Path]) -> Path:
    common = Path(os.path.commonpath([p.resolve() for p in paths]))
    return common if common.is_dir() else common.parent


def make_session(options: LintOptions, config: Config, located: Located) -> Session:
    profiles = {Profile.DEFAULT}
    profiles |= {Profile.PEDANTIC} if options.pedantic or config.pedantic else set()
    profiles |= {Profile.RELEASE} if options.release or config.release else set()
    for name in (*options.select, *options.ignore, *options.extend_select):
        if not codes_named(name):
            hint = did_you_mean(name, rule_names())
            raise UsageError(f"there is no rule `{name}`{hint}; `rospkg rules` lists them")
    selection = Selection(
        select=options.select or config.select,
        ignore=options.ignore,
        extend=options.extend_select + config.extend_select,
        profiles=frozenset(profiles),
    )
    return Session(
        DiskTree(located.root),
        located.scope,
        selection.codes(),
        targets(options, config),
        Settings(frozenset(config.build_types)),
        pool_for(options.jobs, len(located.scope.folders)),
    )


def targets(options: LintOptions, config: Config) -> Targets:
    """Return the targets: as typed, else the config's, else $ROS_DISTRO, else unknown."""
    names = [each.name for each in DISTROS]
    for name in options.target:
        if name not in names:
            raise UsageError(f"there is no distribution `{name}`{did_you_mean(name, names)}; known: {', '.join(names)}")
    own = os.environ.get("ROS_DISTRO", "")
    return Targets(options.target or config.target or ((own,) if own in names else ()))


def pool_for(jobs: str, packages: int) -> type[Pool] | partial[ProcessPool]:
    if jobs == "auto":
        count = min(os.cpu_count() or 1, 8) if packages >= SERIAL_BELOW else 1
    elif jobs.isdecimal() and int(jobs):
        count = int(jobs)
    else:
        raise UsageError(f"--jobs wants a number from 1 on, or auto; not `{jobs}`")
    return partial(ProcessPool, jobs=count) if count > 1 else Pool


def run(options: LintOptions, session: Session, judge: Judge, located: Located) -> Repair:
    if not located.scope.given:
        shown = [str(path) for path in options.paths or (Path(),)]
        return Repair(Results() if options.allow_empty else session.nothing(shown, located.hidden))
    if not (options.fix or options.diff):
        return Repair(judge(session.run()))
    safety = (Safety.SAFE, Safety.UNSAFE) if options.unsafe_fixes else (Safety.SAFE,)
    outcome = repair(session, judge, safety)
    for finding, why in outcome.refused:
        print(f"rospkg: the fix of {finding.code} in {finding.place.path} was taken back: {why}", file=sys.stderr)
    return outcome


def with_config(results: Results, session: Session, judge: Judge, located: Located) -> Results:
    """Add what is wrong with the rule names of the config itself."""
    whole = located.scope.given == frozenset(located.scope.folders)
    extra = session.report(None, list(judge.happenings(session.codes, whole)))
    if not extra:
        return results
    return replace(results, findings=tuple(sorted((*results.findings, *extra), key=lambda f: f.sort_key)))


def parse_output(text: str) -> tuple[str, str]:
    name, _, path = text.partition(":")
    if name not in FORMATS or not path:
        raise UsageError(f"--output wants FORMAT:FILE with a format of {', '.join(FORMATS)}; not `{text}`")
    return name, path


def show(options: LintOptions, report: Report, outputs: Sequence[tuple[str, str]]) -> None:
    """Print the report, and write those of --output."""
    with ExitStack() as stack:
        for name, path in outputs:
            Path(path).parent.mkdir(parents=True, exist_ok=True)
            stream: IO[str] = stack.enter_context(Path(path).open("w", encoding="utf-8"))
            render(name, replace(report, color=False), stream)
    to = sys.stderr if options.diff else sys.stdout
    if not (options.quiet and options.format == "text" and not report.results.findings):
        render(options.format, report, to)
    if options.verbose:
        for crash in report.results.crashes:
            print(crash.error, file=sys.stderr)


def status(options: LintOptions, config: Config, report: Report, outcome: Repair) -> int:
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
