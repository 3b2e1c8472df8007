"""The graph for programs, as `schemas/graph.schema.json` describes it."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from .. import __version__
from ..control_characters import in_json, without_surrogates
from .workspace_graph import WorkspaceGraph

SCHEMA = 1


def as_json(graph: WorkspaceGraph) -> Iterator[str]:
    """Yield the lines of a document, in ASCII: what a terminal or a log would obey is escaped as JSON escapes it."""
    yield from ascii_json(document(graph), indent=2).splitlines()


def ascii_json(value: Any, indent: int | None = None) -> str:
    return in_json(without_surrogates(json.dumps(value, indent=indent, ensure_ascii=False)), only_ascii=True)


def document(graph: WorkspaceGraph) -> dict[str, Any]:
    return {
        "schema": SCHEMA,
        "tool": {"name": "rospkg", "version": __version__},
        "nodes": [
            {
                "name": node.name,
                "package": node.package,
                "is_launch_file": node.is_launch_file,
                "is_outside": node.is_outside,
            }
            for node in graph.nodes
        ],
        "edges": [
            {
                "source": edge.source,
                "target": edge.target,
                "kinds": list(edge.kinds),
                "label": edge.label,
                "marks": list(edge.marks),
            }
            for edge in graph.edges
        ],
    }
