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


def unfound_plugins(block: NodeBlock) -> Iterator[tuple[ScalarNode, str]]:
    """Yield each listed name that has no group, where exactly one group that no list names is meant.

    That is the only one, where one name has no group; else the only one with a similar name.
    """
    groups = {name.removesuffix(f".{TYPE}") for each in block.parameters if (name := each.name).endswith(f".{TYPE}")}
    used = {each.name.partition(".")[0] for each in block.parameters if "." in each.name}
    named = {
        each.value.text for each in block.parameters if ONE.fullmatch(each.name) and isinstance(each.value, ScalarNode)
    }
    listed = [
        item
        for each in block.parameters
        if LISTS.fullmatch(each.name) and isinstance(each.value, SequenceNode)
        for item in each.value.items
        if isinstance(item, ScalarNode)
    ]
    unlisted = {group for group in groups if "." not in group} - {item.text for item in listed} - named
    unmatched = [item for item in listed if item.text not in used]
    for item in unmatched:
        found = list(unlisted) if len(unlisted) == len(unmatched) == 1 else near_names(item.text, unlisted)
        if len(found) == 1:
            yield item, found[0]
