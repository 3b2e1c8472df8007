"""The graph as text for people: each package with what it needs."""

from __future__ import annotations

from collections.abc import Iterator

from ..control_characters import visible
from .workspace_graph import MARKS, GraphEdge, WorkspaceGraph


def as_list(graph: WorkspaceGraph) -> Iterator[str]:
    """Yield lines: a node, and below it a line for each edge from it; the sums at the end."""
    outside = {node.name for node in graph.nodes if node.is_outside}
    from_node: dict[str, list[GraphEdge]] = {}
    for edge in graph.edges:
        from_node.setdefault(edge.source, []).append(edge)
    width = max((len(",".join(edge.kinds)) for edge in graph.edges), default=0)
    for node in graph.nodes:
        if node.is_outside or (node.is_launch_file and node.name not in from_node):
            continue
        yield visible(node.name)
        for edge in from_node.get(node.name, ()):
            notes = [*edge.marks, *(["outside"] if edge.target in outside else [])]
            what = f": {visible(edge.label)}" if edge.label else ""
            yield f"  {','.join(edge.kinds):<{width}}  {visible(edge.target)}{what}" + (
                f"  ({', '.join(notes)})" if notes else ""
            )
    yield sums(graph)


def sums(graph: WorkspaceGraph) -> str:
    """Return how many packages, launch files and edges there are, and how many edges carry each mark."""
    here = [node for node in graph.nodes if not node.is_outside]
    files = sum(node.is_launch_file for node in here)
    marked = [f"{mark}: {sum(mark in edge.marks for edge in graph.edges)}" for mark in MARKS]
    counts = [f"packages: {len(here) - files}", f"launch files: {files}", f"edges: {len(graph.edges)}"]
    return ", ".join(counts + marked)
