"""What starts RViz or move_group, which show a robot: in a launch file, and in a package as far as its facts say."""

from __future__ import annotations

from ...lazy_regex import regex
from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import LaunchedNode
from ...package.package_facts import PackageFacts
from ...source import Span
from .idle_actions import OFF, level_at

SHOWS = frozenset({("rviz2", "rviz2"), ("moveit_ros_move_group", "move_group")})
COMMAND = regex(r"(?:^|[\s/])(?:rviz2|move_group)(?:\s|$)")
OF_MOVEIT = "moveit_configs_utils"
"""Its functions make the launch descriptions of demos, and of move_group and RViz alone."""


def started_viewers(file: LaunchFile) -> list[Span]:
    """Return the nodes and commands of a launch file that start RViz or move_group, conditions aside."""
    nodes = [each.span for each in file.nodes if program_of(each) in SHOWS]
    said = ((each.span, " ".join(word.literal or "?" for word in each.words)) for each in file.commands)
    return nodes + [span for span, text in said if COMMAND.search(text)]


def shows(facts: PackageFacts) -> bool:
    is_of_moveit = any(each.name == OF_MOVEIT for each in facts.dependencies)
    return is_of_moveit or not SHOWS.isdisjoint(facts.started_nodes)


def is_on(file: LaunchFile, span: Span) -> bool:
    level, why = level_at(file, span)
    return level != "info" and why != OFF


def program_of(node: LaunchedNode) -> tuple[str, ...]:
    return tuple(each.literal or "" if each else "" for each in (node.package, node.executable))
