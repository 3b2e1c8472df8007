"""Lists of plugins by name, as nav2 has them: each name is a group with a `plugin` of its own."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.yaml.nodes import ScalarNode, SequenceNode
from ...lazy_regex import regex
from ...package.params.parameter_file import NodeBlock

LISTS = regex(r"(?:.*[._])?plugins|(?:.*[._])?plugin_ids|filters")
TYPE = "plugin"


def unfound_plugins(block: NodeBlock) -> Iterator[tuple[ScalarNode, str]]:
    """Yield each listed name that has no group, where the block has exactly one group that no list names."""
    groups = {name.removesuffix(f".{TYPE}") for each in block.parameters if (name := each.name).endswith(f".{TYPE}")}
    used = {each.name.partition(".")[0] for each in block.parameters if "." in each.name}
    listed = [
        item
        for each in block.parameters
        if LISTS.fullmatch(each.name) and isinstance(each.value, SequenceNode)
        for item in each.value.items
        if isinstance(item, ScalarNode)
    ]
    unlisted = {group for group in groups if "." not in group} - {item.text for item in listed}
    unmatched = [item for item in listed if item.text not in used]
    if len(unlisted) == 1 and len(unmatched) == 1:
        yield unmatched[0], next(iter(unlisted))
