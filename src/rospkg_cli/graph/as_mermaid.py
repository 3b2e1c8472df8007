"""The graph for Mermaid, as GitHub and GitLab draw it: https://mermaid.js.org/syntax/flowchart.html."""

from __future__ import annotations

from collections.abc import Iterator

from ..control_characters import visible
from ..lazy_regex import regex
from .workspace_graph import EdgeMark, GraphEdge, GraphNode, WorkspaceGraph

COLORS: dict[EdgeMark, str] = {"cycle": "#d00000", "undeclared": "#d07000", "unused": "#808080"}
PLAIN = regex(r"[^\w ./,:()-]")


def as_mermaid(graph: WorkspaceGraph) -> Iterator[str]:
    """Yield the lines of a flowchart; names stand in labels alone, for `end` and the like are words of its syntax."""
    keys = {node.name: f"n{number}" for number, node in enumerate(graph.nodes)}
    yield "flowchart LR"
    yield from (f"  {keys[node.name]}{shape(node)}" for node in graph.nodes)
    for number, edge in enumerate(graph.edges):
        yield f"  {keys[edge.source]} {arrow(edge)}|{escaped(label(edge))}| {keys[edge.target]}"
        if edge.marks:
            yield f"  linkStyle {number} stroke:{COLORS[edge.marks[0]]}"
    if outside := [keys[node.name] for node in graph.nodes if node.is_outside]:
        yield "  classDef outside stroke-dasharray: 4"
        yield f"  class {','.join(outside)} outside"


def shape(node: GraphNode) -> str:
    name = escaped(node.name)
    return f">{name}]" if node.is_launch_file else f"[{name}]"


def arrow(edge: GraphEdge) -> str:
    return "-.->" if {"undeclared", "unused"} & {*edge.marks} else "-->"


def label(edge: GraphEdge) -> str:
    return " ".join([edge.label or ",".join(edge.kinds), *(f"({mark})" for mark in edge.marks)])


def escaped(text: str) -> str:
    """Return a text in quotes; Mermaid writes a character as `#` and its number."""
    return '"' + PLAIN.sub(lambda found: f"#{ord(found.group())};", visible(text)) + '"'
