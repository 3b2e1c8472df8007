"""PRM008: nodes of well-known packages that a launch file gives no value for what they need."""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex
from ...ros.needed_parameters import NEEDED, Needed
from ..fault import Fault
from ..launch.who_meets import level_met
from .launch_parameters import LaunchParameters, NodeArguments

SETS = regex(r"[sS]et_?[pP]arameters?(?:_?[fF]rom_?[fF]ile)?\b")
"""Actions and entities that give parameters to every node behind them."""


def needed_faults(scope: LaunchParameters) -> Iterator[tuple[str, Fault]]:
    """Yield where each node is started; none where a launch file here gives parameters to all nodes."""
    if any(SETS.search(launch.source.text) for launch in scope.launches):
        return
    for each in scope.started:
        needed = needed_by(each, scope) if each.has_all and each.launch.has_entry_point else None
        started = each.node.executable or each.node.plugin
        if needed is None or started is None or {needed.name, needed.instead} & each.names():
            continue
        if not may_be_given(each, needed):
            level, why = level_met(each.launch, started.span, scope.workspace)
            level = "info" if scope.is_left_out(each.launch) else level
            message = f"this node is not given `{needed.name}`: `{started.literal}` {needed.harm}"
            yield each.launch.path, Fault(started.span, f"{message}{why and ', '}{why}; give a value here", level)


def needed_by(each: NodeArguments, scope: LaunchParameters) -> Needed | None:
    """Return what a node needs; one of the workspace may need nothing."""
    node = each.node
    package = node.package.literal if node.package else None
    started = node.plugin if node.kind == "composable_node" else node.executable
    name = started.literal if started else None
    return NEEDED.get((package, name)) if package and name and scope.workspace.named(package) is None else None


def may_be_given(each: NodeArguments, needed: Needed) -> bool:
    """Return whether the command line may hold it."""
    words = [argument.literal for argument in each.node.arguments]
    if None in words or (words and needed.takes_file):
        return True
    return any(part in (word or "") for word in words for part in (":=", "-p", "param"))
