"""Arguments of nodes that launch had once and took away."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...languages.python.evaluate.values import Call
from ...source import Source, Span
from .entity import Entity
from .faults import RemovedArgument
from .values import class_of

RENAMED = {
    "node_executable": "executable",
    "node_name": "name",
    "node_namespace": "namespace",
    "node_plugin": "plugin",
}
"""The keywords of launch_ros that were deprecated in Foxy and removed in Galactic, and what they are called since."""

NODES = frozenset({
    "Node", "LifecycleNode", "ComposableNode", "ComposableLifecycleNode", "ComposableNodeContainer",
})  # fmt: skip


def removed_arguments(calls: Iterable[Call], source: Source) -> Iterator[RemovedArgument]:
    """Yield the removed keywords that nodes are given; none where the file asks which distro it runs on."""
    asks = "DISTRO" in source.text
    found: dict[Span, RemovedArgument] = {}
    for call in calls:
        if class_of(call) not in NODES or (asks and not call.certain):
            continue
        given = {argument.name for argument in call.arguments}
        for argument in call.arguments:
            now = RENAMED.get(argument.name)
            span = Span(argument.span.start, argument.span.start + len(argument.name))
            if now is not None and source.slice(span) == argument.name:
                found[span] = RemovedArgument(span, argument.name, now, now in given)
    yield from found.values()


def typed_nodes(root: Entity) -> Iterator[RemovedArgument]:
    """Yield `type=` of nodes, which is `exec=` in ROS 2."""
    for entity in root.walk():
        if entity.name == "node" and "type" in entity.attributes:
            yield RemovedArgument(entity.attribute_spans["type"], "type", "exec", "exec" in entity.attributes)
