"""The order of events in an XML or YAML launch file: that of the text."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.located_text import LocatedText
from ...ros.launch_entities import ACTIONS
from .configuration_events import Event, file_name, passing, uses_of
from .entity import Entity
from .substitution import SubstitutionError, parse_text
from .text import LaunchText, unknown_text

LATER = frozenset({"timer", "ros_timer"})


def xml_events(root: Entity) -> tuple[Event, ...]:
    """Return the events of a launch file; what timers start comes last."""
    deferred: list[Event] = []
    return (*events_of(root, deferred), Event("later"), *deferred)


def events_of(entity: Entity, deferred: list[Event]) -> Iterator[Event]:
    """Yield the events of an action, and of what stands inside of it."""
    name = entity.name
    if name == "arg":
        yield from uses_of(*texts(entity, "default", "if", "unless"))
        yield Event("declare", plain(entity, "name"), entity.name_span, optional="default" not in entity.attributes)
    elif name == "let":
        yield from uses_of(*texts(entity))
        yield Event("define", plain(entity, "name"), entity.name_span)
    elif name == "include":
        yield from include(entity)
    elif name == "group":
        yield from group(entity, deferred)
    elif name == "reset":
        yield Event("open")
    else:
        yield from uses_of(*texts(entity))
        kind = ACTIONS.get(name)
        for child in entity.children:
            if name in LATER:
                deferred += list(events_of(child, deferred))
            else:
                yield from events_of(child, deferred) if kind is not None and kind.actions else parts(child)
        if kind is None:
            yield Event("open")


def parts(entity: Entity) -> Iterator[Event]:
    """Yield what stands inside of an action that takes no actions: all of it is used."""
    for each in entity.walk():
        yield from uses_of(*texts(each))


def include(entity: Entity) -> Iterator[Event]:
    given = entity.named("arg", "let")
    yield from uses_of(*texts(entity))
    for each in given:
        name = plain(each, "name")
        yield from passing(uses_of(*texts(each)), name)
        yield Event("pass", name, each.name_span)
    file = read(entity.attributes["file"]) if "file" in entity.attributes else None
    yield Event("include", file_name(file) if file is not None else "", entity.name_span)


def group(entity: Entity, deferred: list[Event]) -> Iterator[Event]:
    yield from uses_of(*texts(entity))
    scoped = entity.attributes.get("scoped")
    alone = scoped is None or scoped.text.strip().lower() in ("true", "1")
    if alone:
        yield Event("push")
    for child in entity.children:
        if child.name == "keep":
            yield from uses_of(*texts(child))
            yield Event("define", plain(child, "name"), child.name_span)
        else:
            yield from events_of(child, deferred)
    if alone:
        yield Event("pop")


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
