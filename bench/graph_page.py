"""How long the page of `graph --format html` takes in Chromium: python -m bench.graph_page [PACKAGES…]

A synthetic workspace: each package needs up to four of those before it, most of them near; one in five has launch
files.
Seconds are wall time, from the call of the driver to the count of what is shown.
"""

from __future__ import annotations

import random
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from rospkg_cli.graph.as_html import as_html
from rospkg_cli.graph.workspace_graph import GraphEdge, GraphNode, WorkspaceGraph

sys.path.insert(0, str(Path(__file__).parents[1] / "tests/real"))
CHANGE = "arguments[0].dispatchEvent(new Event('input', {bubbles: true}))"


def synthetic(size: int, seed: int = 5) -> WorkspaceGraph:
    rng = random.Random(seed)
    names = [f"package_{number:05}" for number in range(size)]
    edges = {}
    for at in range(1, size):
        for _ in range(rng.randint(0, 4)):
            other = names[max(0, at - 1 - int(rng.expovariate(1 / 60)))] if rng.random() < 0.8 else names[at // 20]
            if other != names[at]:
                edges[names[at], other] = GraphEdge(names[at], other, ("build", "exec"))
    nodes = [GraphNode(name, name) for name in names]
    for name in names[::5]:
        launch = GraphNode(f"{name}/launch/up.launch.py", name)
        nodes.append(launch)
        edges[name, launch.name] = GraphEdge(name, launch.name, ("launch",))
        edges[launch.name, name] = GraphEdge(launch.name, name, ("launch",), "node")
    ordered = tuple(edges[pair] for pair in sorted(edges))
    return WorkspaceGraph(tuple(sorted(nodes, key=lambda node: node.name)), ordered)


def timed(act: Callable[[], object]) -> float:
    before = time.perf_counter()
    act()
    return time.perf_counter() - before


def main(sizes: list[int]) -> None:
    from chromium import started_browser  # type: ignore[import-not-found]

    with tempfile.TemporaryDirectory() as folder, started_browser() as browser:
        for size in sizes:
            graph, page = synthetic(size), Path(folder, "graph.html")
            page.write_text("\n".join(as_html(graph)), "utf-8")
            found = {"open": timed(lambda page=page: browser.open(page))}  # type: ignore[misc]
            found["search"] = timed(lambda: browser.find("#search").send_keys("0042"))
            found["choose"] = timed(lambda: browser.find("#names button").click())
            found["near"] = timed(lambda: browser.choose("#depth", "2 steps"))
            found["everything"] = timed(lambda: browser.choose("#depth", "everything"))
            found["a kind off"] = timed(lambda: browser.find("[value=launch]").click())
            said = ", ".join(f"{what} {seconds:.1f} s" for what, seconds in found.items())
            print(f"{size} packages, {len(graph.edges)} edges, {page.stat().st_size // 1000} kB: {said}")
            print(f"  {browser.text('#count')}")


if __name__ == "__main__":
    main([int(word) for word in sys.argv[1:]] or [100, 1000])
