"""Rule input: a parameter file with what rcl refuses in it, and the nodes that would stop at that (PRM001, PRM004)."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...languages.yaml.nodes import MappingNode, ScalarNode, SequenceNode, YamlNode
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ..fault import Fault, Level, softer_advice
from .block_readers import BlockReaders
from .parameter_file_use import ParameterFileUse

ALIAS = regex(r"rcl does not support aliases \(`\*([^`]+)`\)")

MERGES = regex(r"<<[ \t]*:[ \t]*\Z")


@dataclass(frozen=True)
class RefusedValues:
    use: ParameterFileUse
    readers: BlockReaders

    @property
    def level(self) -> Level | None:
        """The level of what rcl refuses: an info where only nodes that are never started are given the file."""
        return "info" if self.readers.is_unopened(self.use.file) else self.use.level

    @property
    def level_in_rcl(self) -> Level | None:
        """The same of what PyYAML reads: an info where launch files give the file to components alone."""
        given = self.readers.given(self.use.file)
        is_for_components = bool(given) and all(each.node.kind == "composable_node" for each in given)
        return "info" if is_for_components and not self.use.is_handed else self.level

    def is_resolved(self, fault: Fault) -> bool:
        """Return whether a fault is an alias of one value, or merges plain ones, which launch writes out."""
        file, found = self.use.file, ALIAS.match(fault.message)
        if found is None or self.use.is_handed or not self.use.is_resolved:
            return False
        if MERGES.search(file.source.text[: fault.span.start]) is not None:
            return any(is_plain_mapping(each, found[1]) for root in file.roots for each in nodes_of(root))
        anchor = re.search(rf"&{re.escape(found[1])}[ \t]+[^\s\[{{|>&*!#]", file.source.text)
        return anchor is not None and not re.match(r"[^\n#]*:(?:\s|$)", file.source.text[anchor.end() - 1 :])

    def at_its_level(self, fault: Fault) -> Fault:
        """Return an empty list as an info where no node in C++ is shown to read its block.

        rclcpp converts the values of its own blocks alone.
        """
        if self.readers.is_idle(self.use.file.path, fault.span):
            return replace(fault, level="info")
        from .list_readers import UNSHOWN, ListReaders  # few files have an empty list

        if self.level == "info" or ListReaders(self.use, self.readers).has(fault.span):
            return fault
        return softer_advice(fault, "info", UNSHOWN)


def is_plain_mapping(node: YamlNode, anchor: str) -> bool:
    """Return whether a node has the anchor of an alias: a mapping without lists, which PyYAML would share again."""
    if not isinstance(node, MappingNode) or node.anchor != anchor:
        return False
    return all(isinstance(value, ScalarNode) for _, value in node.entries)


def nodes_of(node: YamlNode) -> Iterator[YamlNode]:
    yield node
    inner = node.items if isinstance(node, SequenceNode) else []
    values = [value for _, value in node.entries] if isinstance(node, MappingNode) else []
    for each in (*inner, *values):
        yield from nodes_of(each)
