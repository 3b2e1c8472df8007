"""Nodes that a plain `ros2 launch` does not start: what is given to them does less harm, or none."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from typing import Protocol, TypeVar

from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import LaunchedNode
from ...package.workspace import Workspace
from ...source import Span
from ..fault import Level
from ..launch.idle_actions import OFF
from ..launch.who_meets import level_met

Start = tuple[LaunchFile, Span, Workspace]
"""A launch file, where it starts a node, and the packages that are there."""
MILDER: tuple[Level | None, ...] = (None, "warning", "info")


class NodeSetting(Protocol):
    """What a launch file or a parameter file sets for a node, with the place that starts this node."""

    @property
    def start(self) -> Start | None: ...


NodeSettingT = TypeVar("NodeSettingT", bound=NodeSetting)


def start_of(launch: LaunchFile, node: LaunchedNode, workspace: Workspace) -> Start:
    started = node.executable or node.plugin
    return launch, started.span if started is not None else node.span, workspace


def level_of(start: Start | None) -> tuple[Level | None, str]:
    """Return the level of what a node is given, None for the rule's own, and the end of the sentence."""
    level, why = level_met(*start) if start is not None else (None, "")
    return level, f"{why and ', '}{why}"


def may_start(start: Start | None) -> bool:
    """Return whether something may start a node: nothing does where its action is never added."""
    level, why = level_of(start)
    return level != "info" or why.endswith(OFF)


def hardest(found: Iterable[tuple[Hashable, NodeSettingT]]) -> Iterable[NodeSettingT]:
    """Return one for each place: where nodes share a value, that of the node which is started most certainly."""
    kept: dict[Hashable, NodeSettingT] = {}
    for place, each in found:
        before = kept.setdefault(place, each)
        if before is not each and rank(each.start) < rank(before.start):
            kept[place] = each
    return kept.values()


def rank(start: Start | None) -> int:
    return MILDER.index(level_of(start)[0])
