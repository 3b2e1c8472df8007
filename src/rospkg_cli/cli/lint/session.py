"""From the options of `rospkg lint` and the config to a session."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from functools import partial

from ... import __version__
from ...config.file import Config
from ...config.hierarchy import ConfigTree
from ...config.required_version import satisfies
from ...disk import DiskTree
from ...engine.discovery.locate import Located
from ...engine.run.codes_of_packages import CodesOfPackages
from ...engine.run.pool import SERIAL_BELOW, Pool
from ...engine.run.scope import Scope
from ...engine.run.session import Session
from ...engine.selection import Selection, codes_named, rule_names
from ...index import NamesError
from ...index.cache import names
from ...light_dataclasses import replace
from ...package.rule_settings import RuleSettings
from ...ros.distros import Targets, fault_of_name
from ...ros.names import BUILT_IN, Names
from ...rule import Profile
from ...suggest import did_you_mean
from ...tree import Tree
from .. import UsageError
from ..streams import say
from .lint_options import LintOptions, RuleOptions
from .result_filter import result_filter


def make_session(
    options: LintOptions, configs: ConfigTree, located: Located, show_progress: Callable[[str], None]
) -> Session:
    """Return the run that the options and the configs ask for.

    Raises UsageError, ConfigError, PluginError and BaselineError.
    """
    config = configs.root
    require_version(config)
    if config.plugins:
        from ...engine.run.rule_plugins import load_plugins

        load_plugins(config.plugins, located.root, config.folder)
    present = {folder: configs.at(located.root / folder) for folder in located.scope.folders}
    chosen = codes_of_packages(options.rules, config, present)
    return Session(
        DiskTree(located.root, located.scope.folders),
        replace(located.scope, index=known_names()),
        chosen.codes.union(*chosen.special.values()),
        targets(options.rules.target, config),
        RuleSettings(
            frozenset(name for each in [config, *present.values()] for name in each.build_types), config.plugins
        ),
        pool_for(options.jobs, len(located.scope.selected)),
        result_filter(options.suppression.baseline, configs, located),
        show_progress,
        chosen if chosen.special else None,
        reports_switched_off=True,
    )


def codes_of_packages(options: RuleOptions, root: Config, present: Mapping[str, Config]) -> CodesOfPackages:
    """Return the codes of the rules that run, and those of the packages (by folder) whose config has others."""
    of_root = selected_codes(options, root)
    by_config = {root.path: of_root}
    special = {}
    for folder, config in present.items():
        if config.path not in by_config:
            by_config[config.path] = selected_codes(options, config)
        if by_config[config.path] != of_root:
            special[folder] = by_config[config.path]
    return CodesOfPackages(of_root, special)


def selected_codes(options: RuleOptions, config: Config) -> frozenset[str]:
    """Return the codes of the rules that run; raises UsageError for a name that no rule has."""
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
    return selection.codes()


def known_names() -> Names:
    """Return the names that were fetched, else the built-in ones; says so where an index can't be used."""
    try:
        return names(os.environ)
    except NamesError as error:
        say(f"{error}; until then, the built-in names are used")
        return BUILT_IN


def require_version(config: Config) -> None:
    if not config.required_version:
        return
    try:
        fits = satisfies(__version__, config.required_version)
    except ValueError as error:
        raise UsageError(f"{config.path}: required-version: {error}") from None
    if not fits:
        raise UsageError(f"{config.path} requires rospkg {config.required_version}; this is {__version__}")


def targets(typed: tuple[str, ...], config: Config) -> Targets:
    """Return the targets: as typed, else the config's, else $ROS_DISTRO, else unknown; raises UsageError."""
    for name in typed:
        if fault := fault_of_name(name):
            raise UsageError(fault)
    sourced = os.environ.get("ROS_DISTRO", "")
    return Targets(typed or config.target or (() if fault_of_name(sourced) else (sourced,)))


def pool_for(jobs: str, packages: int) -> Callable[[Tree, Scope, Targets, RuleSettings], Pool]:
    """Return what makes the pool for so many packages; raises UsageError for a number of jobs that is none."""
    if jobs == "auto":
        count = min(os.cpu_count() or 1, 8) if packages >= SERIAL_BELOW else 1
    elif jobs.isdecimal() and int(jobs):
        count = int(jobs)
    else:
        raise UsageError(f"--jobs requires a number (1 or more) or auto; not `{jobs}`")
    if count == 1:
        return Pool
    from ...engine.run.process_pool import ProcessPool

    return partial(ProcessPool, jobs=count)
