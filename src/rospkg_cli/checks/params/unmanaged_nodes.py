"""Servers of nav2 that are started and never configured, as no lifecycle manager is given their name."""

from __future__ import annotations

import re

from ...lazy_regex import regex
from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import LaunchedNode
from ...package.launch.live_text import without
from ...package.launch.text import LaunchText, uncommented
from ...ros.known_nodes import known_nodes
from .launch_parameters import LaunchParameters
from .node_parameters import NodeArguments

MANAGER = "nav2_lifecycle_manager"
MANAGED = "nav2_"
"""What packages of nodes begin with that a lifecycle manager configures; they declare their parameters only then."""
OTHERS = regex(r"\bChangeState\b|\bchange_state\b|\bautostart_node\b|\blifecycle\s+set\b")
"""Other ways to configure a node."""


def is_unmanaged(each: NodeArguments, scope: LaunchParameters) -> bool:
    """Return whether launch files start a server and lifecycle managers, and give none of these its name.

    Those that include others, or whose nodes configure themselves, are not known so well.
    """
    name, package = each.usual_name, each.node.package.literal if each.node.package else None
    if not name or package not in known_nodes().get(name, ()) or not package.startswith(MANAGED) or package == MANAGER:
        return False
    managed_here = any(map(is_manager, each.launch.nodes))
    if not managed_here or each.launch.includes or not each.launch.is_complete or each.node.kind != "node":
        return False
    others = (facts for facts in scope.workspace.packages if facts.name != scope.package.name)
    if any((MANAGER, MANAGER.removeprefix(MANAGED)) in facts.started_nodes for facts in others):
        return False
    word = re.compile(rf"\b{re.escape(name)}\b")
    texts = [rest_of(launch) for launch in scope.launches]
    return not any(word.search(text) or OTHERS.search(text) for text in texts)


def is_manager(node: LaunchedNode) -> bool:
    return node.package is not None and node.package.literal == MANAGER


def rest_of(launch: LaunchFile) -> str:
    """Return the text of a launch file without comments, and without what says which nodes it starts."""
    said = ((node.package, node.executable, node.name) for node in launch.nodes)
    spans = [text.span for texts in said for text in texts if isinstance(text, LaunchText) and text.literal]
    return uncommented(launch.path, without(launch.source.text, spans))
