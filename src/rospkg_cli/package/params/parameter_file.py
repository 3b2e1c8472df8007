"""A parameter file: the entries that name nodes, and the block of parameters of each node."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.yaml.nodes import MappingNode, ScalarNode, SequenceNode, YamlNode
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Source
from .node_entries import NodeEntry, node_entries, node_name

FILLED = regex(r"<\w+>|__\w+__|@\w+@")
"""What a program writes something else for: `<robot_namespace>`, `__PORT__`, `@PORT@`."""


@dataclass(frozen=True, slots=True)
class Parameter:
    """One value of a node; `name` with dots."""

    name: str
    key: ScalarNode
    value: YamlNode


@dataclass(frozen=True)
class NodeBlock:
    """The parameters of one node, or of all nodes that its name fits."""

    name: str
    """As rcl puts it together: the keys above `ros__parameters`, with `/` between them."""
    key: ScalarNode
    """The last of these keys."""
    value: YamlNode
    """Below `ros__parameters`."""

    @cached_property
    def parameters(self) -> tuple[Parameter, ...]:
        return tuple(flatten(self.value, "", 0))


@dataclass(frozen=True)
class ParameterFile:
    source: Source
    roots: tuple[YamlNode, ...]
    """A root for each document."""

    @property
    def path(self) -> str:
        return self.source.path

    @cached_property
    def entries(self) -> tuple[NodeEntry, ...]:
        return tuple(entry for root in self.roots if isinstance(root, MappingNode) for entry in node_entries(root, ()))

    @cached_property
    def blocks(self) -> tuple[NodeBlock, ...]:
        named = [entry for entry in self.entries if entry.kind == "block" and entry.above]
        return tuple(NodeBlock(node_name(entry.above), entry.above[-1], entry.value) for entry in named)


def flatten(node: YamlNode, prefix: str, depth: int) -> Iterator[Parameter]:
    """Yield the parameters of a mapping and of those inside it."""
    if not isinstance(node, MappingNode):
        return
    for key, value in node.entries:
        if not isinstance(key, ScalarNode):
            continue
        name = prefix + key.text
        if isinstance(value, SequenceNode):
            value = mapping_in_list(value) or value
        if isinstance(value, MappingNode):
            yield from flatten(value, name + ".", depth + 1)
        else:
            yield Parameter(name, key, value)


def mapping_in_list(items: SequenceNode) -> MappingNode | None:
    """Return the one mapping of a list that rcl does not see the list around: `[{interfaces: [a, b]}]`."""
    only = items.items[0] if len(items.items) == 1 else None
    if not isinstance(only, MappingNode) or not only.entries:
        return None
    return only if len(only.entries) == 1 or all(isinstance(value, SequenceNode) for _, value in only.entries) else None


def has_placeholder(text: str) -> bool:
    """Return whether a text is filled in before rcl sees it: launch substitutions, templates."""
    return any(sign in text for sign in ("$(", "${", "{{", "{%", "<%", "@(")) or FILLED.search(text) is not None
