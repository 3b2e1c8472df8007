"""Nodes with several interfaces: `NAME:subscriber:sensor_msgs/Imu@/imu+publisher:geometry_msgs/Twist@/cmd_vel`."""

from __future__ import annotations

from collections.abc import Sequence

from . import ScaffoldError
from .node_kinds import LANGUAGES, OF, NodeKind
from .node_words import node_words
from .requested_node import RequestedNode

PLUS = "+"
"""What stands between the parts of a node."""

JOINED = ("publisher", "subscriber", "service", "client")
"""What a part may be: actions want threads, and have nodes of their own."""

LONGEST_SENTENCE = 70
"""Of what it does, for the lines that hold it."""

LONGEST_WORD = 24
"""Characters of a topic: names in code that hold longer ones don't fit their lines."""


def part_texts(text: str) -> list[str]:
    """Return each part as the text of a node of its own: they share name and language."""
    first, *others = text.split(PLUS)
    name = first.partition(":")[0].partition("@")[0]
    whole = [first, *(f"{name}:{part}" for part in others)]
    languages = {node_words(each).language for each in whole} - {""}
    if len(languages) > 1:
        raise ScaffoldError(f"`{text}`: a node has one language")
    return [f"{each}:{''.join(languages)}" if languages and not node_words(each).language else each for each in whole]


def joined_node(text: str, parts: Sequence[RequestedNode]) -> RequestedNode:
    """Return a node of several parts; raises ScaffoldError for what can't be in one."""
    for part in parts:
        kind = part.kind.name.removesuffix(OF)
        if part.message is None or kind not in JOINED:
            raise ScaffoldError(
                f"`{text}`: each part is a {', '.join(JOINED[:-1])} or {JOINED[-1]} and names its interface, "
                "as subscriber:sensor_msgs/Imu@/imu+publisher:geometry_msgs/Twist@/cmd_vel"
            )
        if len(part.word) > LONGEST_WORD:
            raise ScaffoldError(
                f"`{text}`: `{part.topic}` has more than {LONGEST_WORD} characters; shorten it by @NAME"
            )
    check_distinct(text, parts)
    return RequestedNode(parts[0].name, kind_of(parts), parts[0].language, parts=tuple(parts))


def check_distinct(text: str, parts: Sequence[RequestedNode]) -> None:
    """Raise ScaffoldError where code would have one name for two things."""
    named = {(part.kind.name, part.word) for part in parts}
    meant = {(part.word, part.topic, part.message) for part in parts}
    if len(named) < len(parts) or len(meant) > len({part.word for part in parts}):
        raise ScaffoldError(f"`{text}`: two topics or services would have one name in code; name them by @NAME")
    messages = {part.message for part in parts}
    if len({message.name for message in messages if message}) < len(messages):
        raise ScaffoldError(f"`{text}`: two interfaces have one name, and Python could import only one of them")


def kind_of(parts: Sequence[RequestedNode]) -> NodeKind:
    """Return what the parts are together; all that is sent has one rate."""
    does = [part.kind.does.removesuffix(" at a steady rate") for part in parts]
    together = f"{', '.join(does[:-1])} and {does[-1]}"
    return NodeKind(
        name="several",
        does=together if len(together) <= LONGEST_SENTENCE else "uses several topics and services",
        says="ready",
        logic="",
        interfaces=tuple(dict.fromkeys(package for part in parts for package in part.kind.interfaces)),
        uses=tuple(use for part in parts for use in part.kind.uses),
        parameters=next((part.kind.parameters for part in parts if part.kind.parameters), ()),
        languages=tuple(LANGUAGES),
        libraries={},
    )
