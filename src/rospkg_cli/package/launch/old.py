"""What ROS 1 said otherwise, in a file of the XML frontend."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...ros.launch_entities import ROS1_ENTITIES, ROS1_SUBSTITUTIONS
from ...source import Source, Span
from .entity import Entity
from .faults import OldSyntax
from .text import LaunchText

ROS2_ENTITIES = frozenset({
    "let", "executable", "lifecycle_node", "node_container", "composable_node", "load_composable_node", "set_env",
    "push_ros_namespace", "push-ros-namespace", "set_parameter", "set_remap", "timer",
})  # fmt: skip
ROS2_TEXTS = ("$(var ", "$(find-pkg-share ", "$(find-pkg-prefix ", "$(exec-in-pkg ", "$(dirname)")


def is_ros1(root: Entity) -> bool:
    """Return whether a file is a leftover of ROS 1: nodes by `type=`, `$(find x)`, and nothing that ROS 2 brought."""
    every = list(root.walk())
    values = " ".join(written.text for entity in every for written in entity.attributes.values())
    new = any(entity.name in ROS2_ENTITIES for entity in every) or any(each in values for each in ROS2_TEXTS)
    if new or any(entity.name == "node" and "exec" in entity.attributes for entity in every):
        return False
    old = any(entity.name == "node" and "type" in entity.attributes for entity in every)
    return old or "$(find " in values or "$(arg " in values


def old_syntax(source: Source, root: Entity, texts: Iterable[LaunchText]) -> Iterator[OldSyntax]:
    """Yield the places of a file for ROS 2 that are still written for ROS 1."""
    yield from old_entities(root, inside="")
    for text in texts:
        for each in text.substitutions():
            if (now := ROS1_SUBSTITUTIONS.get(each.name)) is not None:
                name = Span(each.span.start + 2, each.span.start + 2 + len(each.name))
                new = f"`$({now} …)`" if now else "`$(env NAME default)`"
                written = now and source.slice(name) == each.name
                yield OldSyntax(each.span, f"`$({each.name} …)`", new, name if written else None, now)


def old_entities(entity: Entity, inside: str) -> Iterator[OldSyntax]:
    for child in entity.children:
        new = ROS1_ENTITIES.get(child.name)
        if new is not None and entity.name in ("launch", "group"):
            yield OldSyntax(child.name_span, f"`<{child.name}>` outside of a node" if new else f"`<{child.name}>`", new)
        elif child.name in ("rosparam", "machine") and entity.name == "node":
            yield OldSyntax(child.name_span, f"`<{child.name}>`", ROS1_ENTITIES[child.name])
        yield from old_entities(child, entity.name)
