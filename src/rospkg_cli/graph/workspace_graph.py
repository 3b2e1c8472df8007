"""Nodes and edges, as every way of showing them gets them."""

from __future__ import annotations

from collections.abc import Collection
from typing import Literal

from ..light_dataclasses import dataclass, replace

EdgeKind = Literal["build", "exec", "test", "launch", "interface"]
KINDS: tuple[EdgeKind, ...] = ("build", "exec", "test", "launch", "interface")
EdgeMark = Literal["cycle", "undeclared", "unused"]
MARKS: tuple[EdgeMark, ...] = ("cycle", "undeclared", "unused")


@dataclass(frozen=True)
class GraphNode:
    name: str
    """Of the package; of a launch file its package, `/`, and its path."""
    package: str
    is_outside: bool = False
    """Whether it is none of the packages that the graph is of."""

    @property
    def is_launch_file(self) -> bool:
        return self.name != self.package


@dataclass(frozen=True)
class GraphEdge:
    source: str
    """The name of a node; so is `target`."""
    target: str
    kinds: tuple[EdgeKind, ...]
    """In the order of KINDS."""
    label: str = ""
    """What a launch file starts or loads there, or "includes"."""
    marks: tuple[EdgeMark, ...] = ()
    """In the order of MARKS."""


@dataclass(frozen=True)
class WorkspaceGraph:
    nodes: tuple[GraphNode, ...]
    """Sorted by name."""
    edges: tuple[GraphEdge, ...]
    """Sorted by source and target; each pair once."""

    def of_kinds(self, kinds: Collection[str]) -> WorkspaceGraph:
        """Return the graph with the edges of some kinds; without launch, without launch files too."""
        chosen = [
            replace(edge, kinds=left)
            for edge in self.edges
            if (left := tuple(kind for kind in edge.kinds if kind in kinds))
        ]
        named = {name for edge in chosen for name in (edge.source, edge.target)}
        nodes = [
            node
            for node in self.nodes
            if node.name in named or not (node.is_outside or (node.is_launch_file and "launch" not in kinds))
        ]
        return WorkspaceGraph(tuple(nodes), tuple(chosen))

    def without_outside(self) -> WorkspaceGraph:
        """Return the graph of the packages that are here, and of what is undeclared or unused beyond them."""
        outside = {node.name for node in self.nodes if node.is_outside}
        edges = [edge for edge in self.edges if edge.marks or not {edge.source, edge.target} & outside]
        named = {name for edge in edges for name in (edge.source, edge.target)}
        nodes = [node for node in self.nodes if not node.is_outside or node.name in named]
        return WorkspaceGraph(tuple(nodes), tuple(edges))

    def around(self, package: str, depth: int) -> WorkspaceGraph:
        """Return what is at most so many dependencies away from a package, in either direction.

        A launch file counts as its package, so what it starts is one step away from there.
        """
        package_of = {node.name: node.package for node in self.nodes}
        beside: dict[str, set[str]] = {}
        for edge in self.edges:
            one, other = package_of[edge.source], package_of[edge.target]
            beside.setdefault(one, set()).add(other)
            beside.setdefault(other, set()).add(one)
        found = reached = {package}
        for _ in range(depth):
            reached = {other for name in reached for other in beside.get(name, ())} - found
            found = found | reached
        nodes = tuple(node for node in self.nodes if node.package in found)
        edges = tuple(edge for edge in self.edges if {package_of[edge.source], package_of[edge.target]} <= found)
        return WorkspaceGraph(nodes, edges)
