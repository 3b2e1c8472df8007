"""The graph as one page to pan, search and filter. It loads nothing: libraries, style and data are in it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from ..control_characters import visible
from ..light_dataclasses import replace
from ..report.html import digest
from .as_json import ascii_json, document
from .workspace_graph import KINDS, MARKS, WorkspaceGraph

HERE = Path(__file__).parent
SCRIPTS = (
    "library/cytoscape.min.js",
    "library/dagre.min.js.LEGAL.txt",
    "library/dagre.min.js",
    "graph_layout.js",
    "graph_style.js",
    "graph_page.js",
)
"""In the order of their use, as one script; the license of dagre is a comment of its own."""
STYLE_ID = "__________cytoscape_stylesheet"
"""Where cytoscape looks for its style, before it would add one that the page's policy forbids."""


def as_html(graph: WorkspaceGraph) -> Iterator[str]:
    """Yield the page; names of strangers stand in its data alone, and scripts show them as text."""
    style = (HERE / "graph_page.css").read_text("utf-8")
    script = plain("\n".join((HERE / name).read_text("utf-8") for name in SCRIPTS))
    policy = f"default-src 'none'; style-src {digest(style)}; script-src {digest(script)}; base-uri 'none'"
    yield '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">'
    yield f'<meta http-equiv="Content-Security-Policy" content="{policy}">'
    yield '<meta name="viewport" content="width=device-width, initial-scale=1">'
    yield f'<title>rospkg graph</title>\n<style id="{STYLE_ID}">{style}</style>\n</head>\n<body>'
    yield from header()
    yield from panes()
    data = ascii_json(document(shown(graph))).replace("<", "\\u003c")
    yield f'<script type="application/json" id="data">{data}</script>'
    yield f"<script>{script}</script>\n</body>\n</html>"


def plain(script: str) -> str:
    """Return a script that names no other file, which a browser's tools would ask for, and that is ASCII.

    A stream without UTF-8 would change it, and the policy would refuse it.
    """
    lines = [line for line in script.split("\n") if not line.startswith("//# sourceMappingURL=")]
    return "\n".join(lines).encode("ascii", "backslashreplace").decode()


def shown(graph: WorkspaceGraph) -> WorkspaceGraph:
    """Return the graph with names in which nothing turns the direction of writing or is unseen."""
    nodes = tuple(replace(node, name=visible(node.name), package=visible(node.package)) for node in graph.nodes)
    edges = tuple(
        replace(edge, source=visible(edge.source), target=visible(edge.target), label=visible(edge.label))
        for edge in graph.edges
    )
    return WorkspaceGraph(nodes, edges)


def header() -> Iterator[str]:
    yield '<header>\n<h1>rospkg graph</h1>\n<form id="filters">'
    yield '<label>Search <input id="search" type="search" placeholder="name of a package"></label>'
    yield from group("Dependencies", "kind", KINDS)
    yield '<fieldset><legend>Marked</legend><label>only <select id="mark"><option value="">all edges</option>'
    yield '<option value="any">any mark</option>'
    yield "".join(f"<option>{mark}</option>" for mark in MARKS)
    yield "</select></label></fieldset>"
    yield '<fieldset><legend>Also</legend><label><input type="checkbox" id="launch" checked> launch files</label>'
    yield '<label><input type="checkbox" id="outside" checked> what is not here</label></fieldset>'
    yield '<label>Near the chosen <select id="depth"><option value="">everything</option>'
    yield '<option value="1">1 step</option><option value="2">2 steps</option><option value="3">3 steps</option>'
    yield "</select></label>"
    yield '<button type="reset">Show all</button>'
    yield '<button type="button" id="fit">Fit</button>'
    yield '<button type="button" id="theme">Dark or light</button>'
    yield '<output id="count"></output>\n</form>\n</header>'


def group(title: str, name: str, values: tuple[str, ...]) -> Iterator[str]:
    boxes = "".join(f'<label><input type="checkbox" name="{name}" value="{v}" checked> {v}</label>' for v in values)
    yield f"<fieldset><legend>{title}</legend>{boxes}</fieldset>"


def panes() -> Iterator[str]:
    yield '<main>\n<div id="graph" role="img" aria-label="The graph; the list says the same as text"></div>'
    yield '<aside aria-label="Packages" tabindex="0">\n<section id="details" aria-live="polite" hidden></section>'
    yield '<h2>Packages</h2>\n<ul id="names"></ul>'
    yield '<h2>Lines</h2>\n<ul id="legend">'
    yield from (f'<li><span class="line {mark}"></span>{mark}</li>' for mark in (*MARKS, "launch", "other"))
    yield "</ul></aside>\n</main>"
