"""What one launch file starts, loads and includes, as far as it is written down."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ..package.launch.launch_file import LaunchFile
from ..package.launch.launched_parts import Include
from .workspace_graph import GraphNode

BESIDE = "$(dirname)/"
"""How a launch file begins the path of one in its own folder."""


def launch_node(package: str, path: str) -> GraphNode:
    return GraphNode(f"{package}/{path}", package)


def launched(file: LaunchFile, package: str) -> Iterator[tuple[GraphNode, str]]:
    """Yield each package with what the file starts of it, and each launch file that it includes.

    What only the start will tell is left out.
    """
    for node in file.nodes:
        what = node.plugin if node.kind == "composable_node" else node.executable
        if node.package and node.package.literal and what is not None:
            yield GraphNode(node.package.literal, node.package.literal), what.literal or "…"
    for include in file.includes:
        if found := included(include, file.path, package):
            yield found, "includes"


def included(include: Include, path: str, package: str) -> GraphNode | None:
    """Return the launch file that is included; None where it is not known."""
    if (found := include.file.in_share()) and found[0].literal and found[1]:
        return launch_node(found[0].literal, posixpath.normpath(found[1]))
    shown = include.file.shown
    rest = shown.removeprefix(BESIDE)
    if shown.startswith(BESIDE) and "$(" not in rest and "…" not in rest:
        return launch_node(package, posixpath.normpath(posixpath.join(posixpath.dirname(path), rest)))
    return None
