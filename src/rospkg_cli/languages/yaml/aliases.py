"""One YAML document in which aliases are replaced by the nodes that they refer to."""

from __future__ import annotations

from typing import NoReturn

from ...light_dataclasses import dataclass, field
from ...read_problem import ReadProblem
from ...source import Source, Span
from ...unreadable import UnreadableError
from .nodes import MAX_DEPTH, AliasNode, MappingNode, ScalarNode, SequenceNode, YamlNode, documents

MAX_NODES = 100_000
"""Aliases may make a small text large."""

ResolvedNode = ScalarNode | SequenceNode | MappingNode


def read_resolved(source: Source) -> ResolvedNode | None:
    """Return the one document of a file, None for an empty file.

    Raises UnreadableError for several documents and for invalid YAML.
    """
    roots = documents(source)
    if len(roots) > 1:
        at = first_character(roots[1])
        raise UnreadableError(source.path, at, ReadProblem.YAML_DOCUMENTS)
    return AliasResolver(source).node(roots[0], 0) if roots else None


def first_character(node: YamlNode) -> Span:
    return Span(node.span.start, min(node.span.start + 1, node.span.end))


@dataclass
class AliasResolver:
    source: Source
    anchors: dict[str, YamlNode] = field(default_factory=dict)
    count: int = 0

    def node(self, node: YamlNode, depth: int) -> ResolvedNode:
        """Raises UnreadableError for an alias of nothing, and for what is too deep or too large."""
        self.count += 1
        if depth > MAX_DEPTH or self.count > MAX_NODES:
            self.refuse(node.span, ReadProblem.YAML_SIZE)
        if isinstance(node, AliasNode):
            target = self.anchors.get(node.name)
            if target is None:
                self.refuse(node.span, ReadProblem.YAML_ALIAS, node.name)
            return self.node(target, depth + 1)
        if node.anchor is not None:
            self.anchors[node.anchor] = node
        if isinstance(node, SequenceNode):
            return SequenceNode(node.span, [self.node(item, depth + 1) for item in node.items])
        if isinstance(node, MappingNode):
            return MappingNode(node.span, [(self.node(k, depth + 1), self.node(v, depth + 1)) for k, v in node.entries])
        return node

    def refuse(self, span: Span, code: ReadProblem, *details: str) -> NoReturn:
        raise UnreadableError(self.source.path, span, code, *details)
