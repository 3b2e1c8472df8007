"""A parameter file: the entries that name nodes, and the block of parameters of each node."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Literal

from ...languages.yaml.nodes import MappingNode, ScalarNode, SequenceNode, YamlNode
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Source
from ...suggest import distance

KEY = "ros__parameters"
MISSPELT_KEY = regex(r"_*ros_+param(?:eter)?s?_*|_*rosparameters?_*", re.IGNORECASE)

FILLED = regex(r"<\w+>|__\w+__|@\w+@")
"""What a program writes something else for: `<robot_namespace>`, `__PORT__`, `@PORT@`."""

EntryKind = Literal["block", "namespace", "after block", "no block", "value", "no name"]


@dataclass(frozen=True, slots=True)
class NodeEntry:
    """An entry of a mapping above the parameters, whose keys are namespaces, names of nodes and `ros__parameters`."""

    kind: EntryKind
    """`block`: the key is `ros__parameters`, or nearly; `namespace`: blocks are below it, or nothing; `after block`: a
    mapping behind the block of the same node; `no block`: a mapping with values and without `ros__parameters`;
    `value`: something else than a mapping; `no name`: the key is no scalar."""
    above: tuple[ScalarNode, ...]
    """The keys above it, the outermost first."""
    key: YamlNode
    value: YamlNode
    is_after_block: bool = False
    """Whether a block of the same node comes before it."""


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


def node_entries(mapping: MappingNode, above: tuple[ScalarNode, ...]) -> Iterator[NodeEntry]:
    """Yield the entries of a mapping and, below namespaces, of those inside it."""
    is_after_block = False
    for key, value in mapping.entries:
        kind = kind_of(key, value, is_after_block)
        yield NodeEntry(kind, above, key, value, is_after_block)
        if kind == "block":
            is_after_block = bool(above)
        elif kind == "namespace" and isinstance(key, ScalarNode) and isinstance(value, MappingNode):
            yield from node_entries(value, (*above, key))


def kind_of(key: YamlNode, value: YamlNode, is_after_block: bool) -> EntryKind:
    if not isinstance(key, ScalarNode):
        return "no name"
    if is_key(key) or (is_misspelt_key(key) and isinstance(value, MappingNode)):
        return "block"
    if not isinstance(value, MappingNode):
        return "value"
    if is_after_block and value.entries:
        return "after block"
    return "namespace" if has_block(value) or not any(isinstance(e, ScalarNode) for e in below(value)) else "no block"


def is_key(node: YamlNode) -> bool:
    """Return whether rcl takes it for `ros__parameters`: it compares the beginning only."""
    return isinstance(node, ScalarNode) and node.text.startswith(KEY)


def is_misspelt_key(node: YamlNode) -> bool:
    if not isinstance(node, ScalarNode) or is_key(node):
        return False
    return MISSPELT_KEY.fullmatch(node.text) is not None or distance(node.text, KEY, 1) == 1


def has_block(node: YamlNode) -> bool:
    mappings = (each for each in below(node) if isinstance(each, MappingNode))
    return any(is_key(key) or is_misspelt_key(key) for each in mappings for key, _ in each.entries)


def node_name(keys: Sequence[ScalarNode]) -> str:
    """Join keys as rcl does, with one `/` between them where none is."""
    whole = keys[0].text
    for key in keys[1:]:
        whole += key.text if whole.endswith("/") else f"/{key.text}"
    return whole


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


def below(node: YamlNode) -> Iterator[YamlNode]:
    """Yield a node and all below it, in order, without recursion."""
    waiting = [node]
    while waiting:
        each = waiting.pop()
        yield each
        if isinstance(each, SequenceNode):
            waiting += reversed(each.items)
        elif isinstance(each, MappingNode):
            waiting += [part for entry in reversed(each.entries) for part in reversed(entry)]


def has_placeholder(text: str) -> bool:
    """Return whether a text is filled in before rcl sees it: launch substitutions, templates."""
    return any(sign in text for sign in ("$(", "${", "{{", "{%", "<%", "@(")) or FILLED.search(text) is not None
