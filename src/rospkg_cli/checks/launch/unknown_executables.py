"""Executables that a launch file starts and that their package, one of the workspace, does not install."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...light_dataclasses import replace
from ...suggest import slips
from .executable_use import ExecutableUse
from .node_executables import NodeExecutables
from .one_cause import CausedPlace, reported_in


def unknown_together(started: NodeExecutables) -> Iterator[list[CausedPlace[ExecutableUse]]]:
    """Yield the uses in the package of each unknown executable that is reported in this file; the worst is first."""
    places = (
        CausedPlace((use.facts.name, use.executable), use.level, use.path, use.span, use)
        for each in (started.each_file if next(unknown_executables(started), None) else ())
        for use in unknown_executables(each)
    )
    yield from reported_in(started.scope.file.path, places)


def unknown_executables(started: NodeExecutables) -> Iterator[ExecutableUse]:
    """Yield the nodes whose package installs no such executable anywhere; slips alone where not all are known.

    A path is not looked for in lib/<package>: `which()` of osrf_pycommon 2.0, which launch_ros asks, takes it from
    the current folder, and an absolute one as it is. Launch files of tests that CMake does not run are left alone.
    """
    if started.scope.is_unused_test:
        return
    for node in started.nodes():
        facts, name = node.facts, node.executable
        known = name in node.startable | facts.misplaced_executables or facts.may_write(name)
        is_certain = facts.knows("executables") or bool(slips(name, node.startable))
        known |= node.is_command and bool(node.in_folder)
        if is_certain and not known and not posixpath.isabs(name):
            yield replace(unless_blank(started, node), sister=sister_of(started, node), entry=entry_of(started, node))


def unless_blank(started: NodeExecutables, node: ExecutableUse) -> ExecutableUse:
    """Return a use, as an info where people are to fill its name in (`TODO`, `<your_node>`) or to replace it."""
    from ..python.blank_names import is_blank, is_to_be_replaced  # what few launch files need

    is_open = is_blank(node.executable) or is_to_be_replaced(started.scope.file.source.text, node.span.start)
    return replace(node, level="info", why="until the name is filled in") if is_open else node


def entry_of(started: NodeExecutables, node: ExecutableUse) -> str:
    """Return the only executable of this package that starts the module whose name a node has; "" for none."""
    table, module = started.scope.table, node.executable.removesuffix(".py")
    if table is None or node.facts is not started.scope.package:
        return ""
    rows = (row for row in table.of("executable") if row.entry.partition(":")[0].rpartition(".")[2] == module)
    names = {row.destination.rpartition("/")[2] for row in rows}
    return names.pop() if len(names) == 1 else ""


def sister_of(started: NodeExecutables, node: ExecutableUse) -> str:
    having = (each.name for each in started.scope.workspace.having("executables", node.executable))
    return next(having, "")
