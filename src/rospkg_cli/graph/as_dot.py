"""The graph for Graphviz: https://graphviz.org/doc/info/lang.html."""

from __future__ import annotations

from collections.abc import Iterator

from ..control_characters import visible
from .workspace_graph import EdgeMark, GraphEdge, GraphNode, WorkspaceGraph

STYLES: dict[EdgeMark, str] = {
    "cycle": "color=red, penwidth=2",
    "undeclared": "color=darkorange, style=dashed",
    "unused": "color=gray50, style=dotted",
}


def as_dot(graph: WorkspaceGraph) -> Iterator[str]:
    """Yield the lines of a digraph."""
    yield "digraph workspace {"
    yield "  rankdir=LR;"
    yield "  node [shape=box, style=rounded];"
    yield from (f"  {quoted(node.name)}{node_style(node)};" for node in graph.nodes)
    yield from (f"  {quoted(e.source)} -> {quoted(e.target)} [{edge_style(e)}];" for e in graph.edges)
    yield "}"


def node_style(node: GraphNode) -> str:
    if node.is_launch_file:
        return " [shape=note, style=solid]"
    return " [style=dashed, color=gray50]" if node.is_outside else ""


def edge_style(edge: GraphEdge) -> str:
    text = " ".join([edge.label or ",".join(edge.kinds), *(f"({mark})" for mark in edge.marks)])
    return ", ".join([f"label={quoted(text)}", *(STYLES[mark] for mark in edge.marks[:1])])


def quoted(text: str) -> str:
    """Return a string of DOT; in a label a backslash would begin an escape."""
    return '"' + visible(text).replace("\\", "\\\\").replace('"', '\\"') + '"'
