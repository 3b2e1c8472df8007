"""What is typed of a node, word by word: `NAME[:KIND][:LANGUAGE][:PACKAGE/Interface][@TOPIC][:QOS]`."""

from __future__ import annotations

from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from . import ScaffoldError
from .message import is_message
from .node_kinds import LANGUAGES, offered_kinds
from .qos import QOS
from .short_words import closest_name

TOPIC = regex(r"(?:~/|/)?[A-Za-z][A-Za-z0-9]*(?:_[A-Za-z0-9]+)*(?:/[A-Za-z][A-Za-z0-9]*(?:_[A-Za-z0-9]+)*)*")
"""A name of a topic, service or action as rmw takes it everywhere: no `__`, no `_` at an end, no substitution."""

LONGEST_TOPIC = 28
"""Longer names don't fit the lines of code that hold them."""


@dataclass(frozen=True)
class NodeWords:
    """The parts of one node, "" for each that was not typed."""

    name: str
    kind: str
    language: str
    interface: str
    topic: str
    qos: str


def node_words(text: str) -> NodeWords:
    """Return the parts, which may follow the name in any order; raises ScaffoldError."""
    name, *typed = text.split(":")
    words = [word.partition("@")[0] for word in typed]
    topics = [word.partition("@")[2] for word in typed if "@" in word]
    if "/" in name.partition("@")[0]:
        raise ScaffoldError(f"`{name}` is a node of another package: a package of --type bringup starts such ones")
    if "@" in name:
        name, _, topic = name.partition("@")
        topics.append(topic)
    words = [word for word, whole in zip(words, typed, strict=True) if word or "@" not in whole]
    languages = [word for word in words if word in LANGUAGES]
    interfaces = [word for word in words if is_message(word)]
    profiles = [word for word in words if word in QOS]
    kinds = [word for word in words if word not in (*languages, *interfaces, *profiles)]
    kinds = [word for word in kinds if word not in offered_kinds()][:1] or kinds
    if max(map(len, (languages, kinds, interfaces, topics, profiles))) > 1:
        raise ScaffoldError(f"`{text}` has too many parts: a node is NAME, NAME:KIND or NAME:KIND:LANGUAGE")
    for topic in topics:
        check_topic(topic)
    found = ("".join(each) for each in (kinds, languages, interfaces, topics, profiles))
    return NodeWords(name, *found)


def check_topic(topic: str) -> None:
    """Raise ScaffoldError for what ROS takes for no name, and for what is too long."""
    if not TOPIC.fullmatch(topic):
        raise ScaffoldError(f"`@{topic}` can't be the name of a topic, service or action; write it as @/scan or @scan")
    if len(topic) > LONGEST_TOPIC:
        raise ScaffoldError(f"`@{topic}` is too long: {len(topic)} characters; at most {LONGEST_TOPIC}")


def unknown_word(word: str, kinds: tuple[str, ...]) -> str:
    """Return what may have been intended by a word that is none of those above."""
    return closest_name(word, [*kinds, *LANGUAGES, *QOS])
