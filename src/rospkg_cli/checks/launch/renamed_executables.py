"""Executables that a launch file starts and that a well-known package, such as nav2_amcl, does not have."""

from __future__ import annotations

from collections.abc import Iterator

from ...ros.well_known import removed, wrong_name
from ...source import Span
from ..fault import Level
from .executable_use import WellKnownUse
from .idle_actions import level_at
from .named_programs import named_programs
from .node_executables import NodeExecutables, milder
from .one_cause import CausedPlace, reported_in
from .who_meets import level_met


def renamed_together(started: NodeExecutables) -> Iterator[list[CausedPlace[WellKnownUse]]]:
    """Yield the uses in the package of each name that is reported in this file, with their levels; the worst first."""
    places = (
        CausedPlace((use.package, use.name), level_of(each, use), each.scope.file.path, use.executable.span, use)
        for each in (started.each_file if next(renamed(started), None) else ())
        for use in renamed(each)
    )
    yield from reported_in(started.scope.file.path, places)


def renamed(started: NodeExecutables) -> Iterator[WellKnownUse]:
    """Yield the nodes of well-known packages that are not here, under a name that these do not have."""
    file, workspace = started.scope.file, started.scope.workspace
    seen: set[Span] = set()  # a loop starts one node several times
    for each in named_programs(file) if not started.scope.is_unused_test else ():
        name, is_here = each.executable.literal or "", workspace.named(each.package) is not None
        wrong = None if is_here or each.is_command else wrong_name("programs", each.package, name)
        if wrong is not None and each.executable.span not in seen:
            seen.add(each.executable.span)
            level = milder(level_met(file, each.span, workspace), level_at(file, each.executable.span))
            from .other_sources import may_be_another  # few launch files start what is not there

            if other := may_be_another(each.package, workspace, started.scope.files):
                level = "info", other
            is_plain = file.source.slice(each.executable.span) == name
            yield WellKnownUse(each.package, each.executable, name, wrong, *level, is_plain)


def level_of(started: NodeExecutables, use: WellKnownUse) -> Level | None:
    """Return the level of a name that is not there; None for that of the rule.

    A removed name is an info where the repository is for an unsupported distribution, or starts a fork of the
    package, which may have kept it.
    """
    from .forked_packages import is_of_fork  # few launch files start a removed executable

    distribution = started.distribution
    is_older = distribution.is_for_unsupported(started.scope.file.path) or not distribution.is_newer_shown
    is_older = is_older or uses_plugins_of(started, use.package)
    is_kept = is_older or is_of_fork(use.package, started.scope.package, started.scope.workspace)
    if use.wrong.is_removed and is_kept:
        return "info"
    return use.level or ("warning" if use.wrong.is_removed or "/" in use.wrong.better else None)


def uses_plugins_of(started: NodeExecutables, package: str) -> bool:
    """Return whether parameters or descriptions here name plugins that a package had in an unsupported distribution.

    False where a page names a supported distribution: then these names are leftovers as well.
    """
    facts = started.scope.package
    names = {*(each.name for each in facts.plugin_uses), *(each.name for each in facts.plugins)}
    return not names.isdisjoint(removed("plugins").get(package, ())) and not started.distribution.names_supported
