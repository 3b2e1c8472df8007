"""Entries of a parameter file above the parameters: namespaces, names of nodes and ros__parameters."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import Literal

from ...languages.yaml.nodes import MappingNode, ScalarNode, SequenceNode, YamlNode
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...suggest import distance

KEY = "ros__parameters"
MISSPELT_KEY = regex(r"_*ros_+param(?:eter)?s?_*|_*rosparameters?_*", re.IGNORECASE)
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
