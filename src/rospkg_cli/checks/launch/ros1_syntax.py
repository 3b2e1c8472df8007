"""LCH006: ROS 1 syntax in an XML or YAML launch file for ROS 2."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.launch.entity import Entity
from ...package.launch.launch_file import LaunchFile
from ...ros.launch_entities import ROS1_ENTITIES, ROS1_SUBSTITUTIONS
from ...source import Span
from ..fault import Fault, TextRepair

LONGEST = 60
"""Letters of a substitution that the message shows in full, where it is the only one of its kind."""


def first_sign(file: LaunchFile) -> Span:
    """Return the first place by which a file is one for ROS 1: `type=` of a node, `$(find …)`, `$(arg …)`."""
    places = [each.span for each in file.substitutions if each.name in ("find", "arg")]
    for entity in file.root.walk() if file.root is not None else ():
        if entity.name == "node" and "type" in entity.attributes:
            places.append(entity.attribute_spans["type"])
    return min(places, default=Span(0, 0))


def ros1_syntax(file: LaunchFile) -> Iterator[Fault]:
    """Yield the places of a file for ROS 2 that are still written for ROS 1."""
    if file.root is None or file.is_ros1:
        return
    yield from ros1_entities(file.root)
    for each in file.substitutions:
        now = ROS1_SUBSTITUTIONS.get(each.name)
        if now is not None:
            name = Span(each.span.start + 2, each.span.start + 2 + len(each.name))
            new = f"`$({now} …)`" if now else "`$(env NAME default)`"
            is_renamed = now and file.source.slice(name) == each.name
            repair = TextRepair(f"write {new}", ((name, now),)) if is_renamed else None
            same = {other.shown for other in file.substitutions if other.name == each.name}
            old = each.shown if len(same) == 1 and len(each.shown) <= LONGEST else f"$({each.name} …)"
            yield Fault(each.span, message(f"`{old}`", new), repair=repair)


def is_refused(file: LaunchFile) -> bool:
    """Return whether ROS 2 does not read a file for what it still has of ROS 1: no node of it starts."""
    return any(ros1_syntax(file))


def ros1_entities(entity: Entity) -> Iterator[Fault]:
    for child in entity.children:
        new = ROS1_ENTITIES.get(child.name)
        if new is not None and entity.name in ("launch", "group"):
            old = f"`<{child.name}>` outside of a node" if new else f"`<{child.name}>`"
            yield Fault(child.name_span, message(old, new))
        elif child.name in ("rosparam", "machine") and entity.name == "node":
            yield Fault(child.name_span, message(f"`<{child.name}>`", ROS1_ENTITIES[child.name]))
        yield from ros1_entities(child)


def message(old: str, new: str) -> str:
    """Return the message for a piece of syntax and what replaces it in ROS 2; "" where nothing does."""
    ros2 = f", ROS 2 has {new}" if new else " and ROS 2 has nothing like it"
    return f"{old} is ROS 1's{ros2}: `ros2 launch` refuses the file"
