"""LCH005: arguments of nodes that launch had once and removed."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.launch.evaluated_launch import EvaluatedLaunch
from ...package.launch.launch_classes import class_of
from ...package.launch.launch_file import LaunchFile
from ...source import Source, Span
from ..fault import Fault, TextRepair

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


def removed_arguments(file: LaunchFile) -> Iterator[Fault]:
    """Yield the removed arguments of Python and XML nodes; `type=` of XML nodes is `exec=` in ROS 2."""
    if file.evaluated is not None:
        found = dict(python_arguments(file.evaluated, file.source))
        yield from (removed(span, name, RENAMED[name], both) for span, (name, both) in found.items())
    for entity in file.root.walk() if file.root is not None and not file.is_ros1 else ():
        if entity.name == "node" and "type" in entity.attributes:
            yield removed(entity.attribute_spans["type"], "type", "exec", "exec" in entity.attributes)


def python_arguments(launch: EvaluatedLaunch, source: Source) -> Iterator[tuple[Span, tuple[str, bool]]]:
    """Yield the span and the name of each removed keyword, and whether the new one is passed as well.

    None where the file tests which distribution it runs on.
    """
    asks = "DISTRO" in source.text
    for call in launch.calls:
        if class_of(call) not in NODES or (asks and not call.is_certain):
            continue
        names = {argument.name for argument in call.arguments}
        for argument in call.arguments:
            span = Span(argument.span.start, argument.span.start + len(argument.name))
            if argument.name in RENAMED and source.slice(span) == argument.name:
                yield span, (argument.name, RENAMED[argument.name] in names)


def removed(span: Span, name: str, now: str, has_both: bool) -> Fault:
    better = f", and `{now}` is given as well: remove it" if has_both else f"; it is `{now}` now"
    repair = None if has_both else TextRepair(f"call it `{now}`", ((span, now),))
    return Fault(span, f"launch no longer takes `{name}` of a node and stops there{better}", repair=repair)
