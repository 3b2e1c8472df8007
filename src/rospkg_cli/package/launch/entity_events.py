"""The order of events in an XML or YAML launch file: that of the text."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.located_text import LocatedText
from ...ros.launch_entities import ACTIONS
from .configuration_events import LaunchEvent, file_name, passed_uses, uses_of
from .entity import Entity
from .substitution import SubstitutionError, parse_text
from .text import LaunchText, unknown_text

LATER = frozenset({"timer", "ros_timer"})


def xml_events(root: Entity) -> tuple[LaunchEvent, ...]:
    """Return the events of a launch file; what timers start comes last."""
    deferred: list[LaunchEvent] = []
    return (*events_of(root, deferred), LaunchEvent("later"), *deferred)


def events_of(entity: Entity, deferred: list[LaunchEvent]) -> Iterator[LaunchEvent]:
    """Yield the events of an action and of its children."""
    name = entity.name
    if name == "arg":
        yield from uses_of(*texts(entity, "default", "if", "unless"))
        yield LaunchEvent(
            "declare", plain(entity, "name"), entity.name_span, is_optional="default" not in entity.attributes
        )
    elif name == "let":
        yield from uses_of(*texts(entity))
        yield LaunchEvent("define", plain(entity, "name"), entity.name_span)
    elif name == "include":
        yield from include(entity)
    elif name == "group":
        yield from group(entity, deferred)
    elif name == "reset":
        yield LaunchEvent("open")
    else:
        yield from uses_of(*texts(entity))
        kind = ACTIONS.get(name)
        for child in entity.children:
            if name in LATER:
                deferred += list(events_of(child, deferred))
            else:
                yield from events_of(child, deferred) if kind is not None and kind.actions else parts(child)
        if kind is None:
            yield LaunchEvent("open")


def parts(entity: Entity) -> Iterator[LaunchEvent]:
    """Yield the uses below an action that takes no actions."""
    for each in entity.walk():
        yield from uses_of(*texts(each))


def include(entity: Entity) -> Iterator[LaunchEvent]:
    given = entity.named("arg", "let")
    yield from uses_of(*texts(entity))
    for each in given:
        name = plain(each, "name")
        yield from passed_uses(uses_of(*texts(each)), name)
        yield LaunchEvent("pass", name, each.name_span)
    file = read(entity.attributes["file"]) if "file" in entity.attributes else None
    yield LaunchEvent("include", file_name(file) if file is not None else "", entity.name_span)


def group(entity: Entity, deferred: list[LaunchEvent]) -> Iterator[LaunchEvent]:
    yield from uses_of(*texts(entity))
    scoped = entity.attributes.get("scoped")
    alone = scoped is None or scoped.text.strip().lower() in ("true", "1")
    if alone:
        yield LaunchEvent("push")
    for child in entity.children:
        if child.name == "keep":
            yield from uses_of(*texts(child))
            yield LaunchEvent("define", plain(child, "name"), child.name_span)
        else:
            yield from events_of(child, deferred)
    if alone:
        yield LaunchEvent("pop")


def texts(entity: Entity, *names: str) -> list[LaunchText]:
    """Return the attributes of an entity, or those of some names."""
    found = [written for name, written in entity.attributes.items() if not names or name in names]
    found += [each for name, several in entity.lists.items() if not names or name in names for each in several]
    return [read(written) for written in found]


def read(written: LocatedText) -> LaunchText:
    try:
        return parse_text(written)
    except SubstitutionError:
        return unknown_text(written.span)


def plain(entity: Entity, name: str) -> str:
    """Return an attribute that is a plain text; "" where it is none."""
    written = entity.attributes.get(name)
    return (read(written).literal or "") if written is not None else ""
