"""What was typed behind `rospkg lint`, and what it means."""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from ... import __version__
from ...config.file import Config
from ...config.required_version import fulfils
from ...disk import DiskTree
from ...engine.discovery.locate import Located
from ...engine.run.process_pool import SERIAL_BELOW, ProcessPool
from ...engine.run.rule_plugins import load_plugins
from ...engine.run.session import Pool, Session
from ...engine.selection import Selection, codes_named, rule_names
from ...index import NamesError
from ...index.cache import names
from ...package.rule_settings import RuleSettings
from ...report import FORMATS
from ...ros.distros import Targets, fault_of_name
from ...ros.names import BUILT_IN, Names
from ...rule import Profile
from ...suggest import did_you_mean
from .. import UsageError
from ..streams import say


@dataclass(frozen=True)
class LintOptions:
    """What was typed; None where nothing was."""

    paths: tuple[Path, ...] = ()
    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    extend_select: tuple[str, ...] = ()
    pedantic: bool = False
    release: bool = False
    preview: bool = False
    target: tuple[str, ...] = ()
    fail_on: str | None = None
    fix: bool = False
    unsafe_fixes: bool = False
    diff: bool = False
    exit_non_zero_on_fix: bool = False
    add_ignores: str | None = None
    baseline: Path | None = None
    write_baseline: Path | None = None
    statistics: bool = False
    format: str = "text"
    output: tuple[str, ...] = ()
    workspace: Path | None = None
    jobs: str = "auto"
    allow_empty: bool = False
    color: str = "auto"
    verbose: bool = False
    quiet: bool = False


def make_session(options: LintOptions, config: Config, located: Located) -> Session:
    """Return the run that the options and the config ask for; raises UsageError."""
    require_version(config)
    load_plugins(config.plugins, located.root, config.folder)
    for name in (*options.select, *options.ignore, *options.extend_select):
        if not codes_named(name):
            hint = did_you_mean(name, rule_names())
            raise UsageError(f"there is no rule `{name}`{hint}; `rospkg rules` lists them")
    profiles = {Profile.DEFAULT}
    profiles |= {Profile.PEDANTIC} if options.pedantic or config.pedantic else set()
    profiles |= {Profile.RELEASE} if options.release or config.release else set()
    selection = Selection(
        select=options.select or config.select,
        ignore=options.ignore,
        extend=options.extend_select + config.extend_select,
        profiles=frozenset(profiles),
        preview=options.preview,
    )
    return Session(
        DiskTree(located.root, located.scope.folders),
        replace(located.scope, index=known_names()),
        selection.codes(),
        targets(options, config),
        RuleSettings(frozenset(config.build_types), config.plugins),
        pool_for(options.jobs, len(located.scope.folders)),
    )


def known_names() -> Names:
    """Return the names that were fetched, else those that are built in; an index that is of no use is said to be."""
    try:
        return names(os.environ)
    except NamesError as error:
        say(f"{error}; until then, what is built in answers")
        return BUILT_IN


def require_version(config: Config) -> None:
    if not config.required_version:
        return
    try:
        fits = fulfils(__version__, config.required_version)
    except ValueError as error:
        raise UsageError(f"{config.path}: required-version: {error}") from None
    if not fits:
        raise UsageError(f"{config.path} wants rospkg {config.required_version}; this is {__version__}")


def targets(options: LintOptions, config: Config) -> Targets:
    """Return the targets: as typed, else the config's, else $ROS_DISTRO, else unknown."""
    for name in options.target:
        if fault := fault_of_name(name):
            raise UsageError(fault)
    own = os.environ.get("ROS_DISTRO", "")
    return Targets(options.target or config.target or (() if fault_of_name(own) else (own,)))


def pool_for(jobs: str, packages: int) -> type[Pool] | partial[ProcessPool]:
    if jobs == "auto":
        count = min(os.cpu_count() or 1, 8) if packages >= SERIAL_BELOW else 1
    elif jobs.isdecimal() and int(jobs):
        count = int(jobs)
    else:
        raise UsageError(f"--jobs wants a number from 1 on, or auto; not `{jobs}`")
    return partial(ProcessPool, jobs=count) if count > 1 else Pool


def outputs(options: LintOptions) -> list[tuple[str, Path]]:
    """Return the format and the file of each --output; raises UsageError."""
    found = []
    for text in options.output:
        name, _, path = text.partition(":")
        if name not in FORMATS or not path:
            raise UsageError(f"--output wants FORMAT:FILE with a format of {', '.join(FORMATS)}; not `{text}`")
        found.append((name, Path(path)))
    return found
