"""PRM008: nodes of well-known packages that a launch file gives no value for what they need."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...package.launch.launch_file import LaunchFile
from ...ros.needed_parameters import NEEDED, Needed
from ..fault import Fault
from ..launch.who_meets import level_met
from .given_otherwise import may_be_set
from .launch_parameters import LaunchParameters
from .node_parameters import NodeArguments


def needed_faults(scope: LaunchParameters) -> Iterator[tuple[str, Fault]]:
    """Yield where each node is started."""
    for each in scope.started:
        needed = needed_by(each, scope) if each.has_all and each.launch.has_entry_point else None
        started = each.node.executable or each.node.plugin
        if needed is None or started is None or {needed.name, needed.instead} & each.names():
            continue
        if not may_be_given(each, needed, scope.launches):
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


def may_be_given(each: NodeArguments, needed: Needed, launches: Iterable[LaunchFile]) -> bool:
    """Return whether the command line may hold it, or a launch file gives it to all nodes."""
    takes_words = bool(each.node.arguments) and needed.takes_file
    return takes_words or may_be_set(each.node, {needed.name, needed.instead}, launches)
