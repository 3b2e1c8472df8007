"""LCH005: arguments of nodes that launch had once and removed."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from ...package.launch.evaluated_launch import EvaluatedLaunch
from ...package.launch.launch_classes import class_of
from ...package.launch.launch_file import LaunchFile
from ...source import Source, Span
from ..enumeration import in_ticks
from ..fault import Fault, TextRepair, joined

LATER = "launch no longer takes"
"""How the message begins about keywords that Foxy takes; the others are of ROS 1."""
RENAMED = {
    "node_executable": "executable",
    "node_name": "name",
    "node_namespace": "namespace",
    "node_plugin": "plugin",
}
"""The keywords of launch_ros that were deprecated in Foxy and removed in Galactic, and what they are called since."""

ROS1 = {"type": "executable", "pkg": "package"}
"""The attributes of ROS 1 that people write as keywords of a node, and what to write instead."""

PROGRAMS = frozenset({"Node", "LifecycleNode"})
NODES = frozenset({
    "Node", "LifecycleNode", "ComposableNode", "ComposableLifecycleNode", "ComposableNodeContainer",
})  # fmt: skip


def removed_arguments(file: LaunchFile) -> Iterator[Fault]:
    """Yield the removed arguments of Python and XML nodes; `type=` of XML nodes is `exec=` in ROS 2."""
    if file.evaluated is not None:
        yield from together(dict(python_arguments(file.evaluated, file.source)))
    for entity in file.root.walk() if file.root is not None and not file.is_ros1 else ():
        if entity.name == "node" and "type" in entity.attributes:
            yield removed(entity.attribute_spans["type"], "type", "exec", "exec" in entity.attributes)


def is_taken_by_old_launch_alone(file: LaunchFile) -> bool:
    """Return whether Python makes an action with a keyword that launch_ros has no more, where it raises."""
    return file.python is not None and any(removed_arguments(file))


def renamed(name: str) -> Mapping[str, str]:
    """Return what the keywords of a class of nodes are called now."""
    return {**RENAMED, **ROS1} if name in PROGRAMS else RENAMED


def python_arguments(launch: EvaluatedLaunch, source: Source) -> Iterator[tuple[Span, tuple[str, bool]]]:
    """Yield the span and the name of each removed keyword, and whether the new one is passed as well.

    None where the file tests which distribution it runs on.
    """
    asks = "DISTRO" in source.text
    for call in launch.calls:
        if class_of(call) not in NODES or (asks and not call.is_certain):
            continue
        names = {argument.name for argument in call.arguments}
        now = renamed(class_of(call))
        for argument in call.arguments:
            span = Span(argument.span.start, argument.span.start + len(argument.name))
            if argument.name in now and source.slice(span) == argument.name:
                yield span, (argument.name, now[argument.name] in names)


def removed(span: Span, name: str, now: str, has_both: bool) -> Fault:
    start = f"`{name}` is ROS 1's: launch takes no such argument of a node and stops there"
    if name not in ROS1:
        start = f"{LATER} `{name}` of a node and stops there"
    better = f", and `{now}` is given as well: remove it" if has_both else f"; write `{now}`"
    repair = None if has_both else TextRepair(f"call it `{now}`", ((span, now),))
    return Fault(span, start + better, repair=repair)


def together(found: Mapping[Span, tuple[str, bool]]) -> Iterator[Fault]:
    """Yield the removed keywords of a file; those of an older launch_ros as one fault, as launch stops at the first."""
    now = {**RENAMED, **ROS1}
    faults = {span: removed(span, name, now[name], has_both) for span, (name, has_both) in found.items()}
    old = {span: name for span, (name, has_both) in found.items() if name in RENAMED and not has_both}
    if len(old) > 1:
        yield joined([faults.pop(span) for span in old], *renaming_texts(old.values()))
    yield from faults.values()


def renaming_texts(names: Collection[str]) -> tuple[str, str]:
    """Return the message about several keywords of Foxy, and the title of the fix that renames them."""
    better = in_ticks(RENAMED[name] for name in names)
    return f"{LATER} {in_ticks(names)} of nodes and stops there; write {better}", f"write {better}"
