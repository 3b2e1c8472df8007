"""Lists of plugins by name, as nav2 has them: each name is a group with a `plugin` of its own."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.yaml.nodes import ScalarNode, SequenceNode
from ...lazy_regex import regex
from ...package.params.parameter_file import NodeBlock
from ...suggest import near_names

LISTS = regex(r"(?:.*[._])?plugins|(?:.*[._])?plugin_ids|filters")
ONE = regex(r".*_plugin")
TYPE = "plugin"
SERVERS = {
    "controller_server": ("controller_plugins", "goal_checker_plugins", "progress_checker_plugins"),
    "planner_server": ("planner_plugins",),
    "smoother_server": ("smoother_plugins",),
    "behavior_server": ("behavior_plugins",),
    "local_costmap": ("plugins", "filters"),
    "global_costmap": ("plugins", "filters"),
}
"""Nodes of nav2 that stop where a listed plugin has no type, with their lists. (nav2_util/node_utils.hpp)"""
WITH_TYPES = frozenset({
    "FollowPath", "GridBased", "goal_checker", "progress_checker", "simple_smoother", "spin", "backup", "wait",
    "drive_on_heading", "assisted_teleop", "static_layer", "obstacle_layer", "inflation_layer",
})  # fmt: skip
"""Names of their default lists, which have types without parameters."""
DEFAULT_LISTS = frozenset({
    ("FollowPath",), ("GridBased",), ("goal_checker",), ("progress_checker",), ("simple_smoother",),
    ("spin", "backup", "drive_on_heading", "wait"), ("spin", "backup", "drive_on_heading", "assisted_teleop", "wait"),
    ("static_layer", "obstacle_layer", "inflation_layer"),
})  # fmt: skip
"""These lists: of such a one the server gives each name its type itself."""


def unfound_plugins(block: NodeBlock) -> Iterator[tuple[ScalarNode, str]]:
    """Yield each listed name that has no group, where exactly one group that no list names is similar.

    That is the only one, where one name has no group; else the only one with a similar name.
    """
    used = {each.name.partition(".")[0] for each in block.parameters if "." in each.name}
    unlisted = unlisted_groups(block)
    unmatched = [(name, item) for name, item in listed_names(block) if item.text not in used]
    for name, item in unmatched:
        is_only = len(unlisted) == len(unmatched) == 1 and not is_default(block, name)
        found = list(unlisted) if is_only else near_names(item.text, unlisted)
        if len(found) == 1:
            yield item, found[0]


def is_default(block: NodeBlock, name: str) -> bool:
    """Return whether a list of plugins is as it is by default: its plugins have types without parameters."""
    lists = (each.value for each in block.parameters if each.name == name)
    return any(isinstance(each, SequenceNode) and texts_of(each) in DEFAULT_LISTS for each in lists)


def texts_of(items: SequenceNode) -> tuple[str, ...]:
    return tuple(item.text for item in items.items if isinstance(item, ScalarNode))


def listed_names(block: NodeBlock) -> list[tuple[str, ScalarNode]]:
    """Return what lists of plugins name, each with the name of its list."""
    return [
        (each.name, item)
        for each in block.parameters
        if LISTS.fullmatch(each.name) and isinstance(each.value, SequenceNode)
        for item in each.value.items
        if isinstance(item, ScalarNode)
    ]


def unlisted_groups(block: NodeBlock) -> set[str]:
    """Return the groups that have a type, and that nothing of the block names."""
    groups = {name.removesuffix(f".{TYPE}") for each in block.parameters if (name := each.name).endswith(f".{TYPE}")}
    named = {
        each.value.text for each in block.parameters if ONE.fullmatch(each.name) and isinstance(each.value, ScalarNode)
    }
    return {group for group in groups if "." not in group} - {item.text for _, item in listed_names(block)} - named


def is_unloaded(block: NodeBlock, group: str) -> bool:
    """Return whether a block lists plugins, and neither a list nor another value of it names the one of a group."""
    if group in WITH_TYPES or not listed_names(block) or group not in unlisted_groups(block):
        return False
    values = [each.value for each in block.parameters]
    items = [item for value in values for item in (value.items if isinstance(value, SequenceNode) else (value,))]
    return all(not isinstance(item, ScalarNode) or item.text != group for item in items)


def doubled_plugins(block: NodeBlock) -> Iterator[tuple[ScalarNode, str, str]]:
    """Yield each name that a list has twice, with its list and the one group of a similar name that no list has."""
    unlisted, seen = unlisted_groups(block), set[tuple[str, str]]()
    for name, item in listed_names(block):
        found = near_names(item.text, unlisted) if (name, item.text) in seen else []
        seen.add((name, item.text))
        if len(found) == 1:
            yield item, name, found[0]


def lost_plugins(block: NodeBlock) -> Iterator[tuple[ScalarNode, str]]:
    """Yield each plugin that a server of nav2 lists and that has no group, where another of the list has one."""
    lists = SERVERS.get(block.name.rpartition("/")[2], ())
    groups = {each.name.partition(".")[0] for each in block.parameters}
    typed = {each.name.removesuffix(f".{TYPE}") for each in block.parameters if each.name.endswith(f".{TYPE}")}
    for each in block.parameters:
        items = each.value.items if each.name in lists and isinstance(each.value, SequenceNode) else ()
        names = [item for item in items if isinstance(item, ScalarNode)]
        for item in names if any(item.text in typed for item in names) else ():
            if item.text not in groups | WITH_TYPES:
                yield item, each.name
