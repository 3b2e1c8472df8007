"""What the XML and YAML frontends refuse: attributes and entities that they do not know where they stand."""

from __future__ import annotations

from collections.abc import Iterator

from ...ros.launch_entities import ACTIONS, INCLUDE_ARGUMENT, PARTS, ROS1_ONLY, SUBSTITUTIONS, EntityKind
from ...suggest import did_you_mean, nearest
from .entity import Entity
from .faults import Fault
from .text import LaunchText


def faults_of(root: Entity) -> Iterator[Fault]:
    """Yield the faults of a launch description, from its root on."""
    for child in root.children:
        yield from action_faults(child)


def action_faults(entity: Entity) -> Iterator[Fault]:
    kind = ACTIONS.get(entity.name)
    if kind is None:
        yield from unknown_action(entity)
        return
    yield from attribute_faults(entity, kind)
    for child in entity.children:
        if child.name in kind.inside:
            yield from part_faults(child, entity.name)
        elif kind.actions:
            yield from action_faults(child)
        elif not kind.open:
            hint = did_you_mean(child.name, kind.inside)
            message = f"`{child.name}` can't stand inside of `{entity.name}`{hint}: launch refuses the whole file"
            yield Fault(child.name_span, message)


def unknown_action(entity: Entity) -> Iterator[Fault]:
    """Speak of an action that is unknown only where it is a known one misspelt: packages add actions of their own."""
    meant = nearest(entity.name, ACTIONS, 1)
    if meant and entity.name not in ROS1_ONLY and entity.name not in PARTS:
        yield Fault(entity.name_span, f"launch has no action `{entity.name}`; did you mean `{meant}`?")


def part_faults(entity: Entity, around: str) -> Iterator[Fault]:
    kind = INCLUDE_ARGUMENT if around == "include" else PARTS[entity.name]
    yield from attribute_faults(entity, kind)
    for child in entity.children:
        if child.name in kind.inside:
            yield from part_faults(child, entity.name)
        else:
            yield Fault(child.name_span, f"`{child.name}` can't stand inside of `{entity.name}`")


def attribute_faults(entity: Entity, kind: EntityKind) -> Iterator[Fault]:
    given, meant = entity.attribute_spans, set()
    if entity.name == "node" and "type" in given:
        given = {**given, "exec": given["type"]}
        del given["type"]
    for name, span in given.items():
        if not kind.takes(name) and name not in kind.inside and not (kind.actions and name == "children"):
            meant.add(nearest(name, kind.attributes | kind.inside))
            hint = did_you_mean(name, kind.attributes | kind.inside)
            message = f"`{entity.name}` has no attribute `{name}`{hint}: launch refuses the whole file"
            yield Fault(span, message)
    for name in sorted(kind.required - given.keys() - meant):
        yield Fault(entity.name_span, f"`{entity.name}` lacks its attribute `{name}`: launch refuses the whole file")
    if {"if", "unless"} <= given.keys():
        yield Fault(given["unless"], f"`{entity.name}` has `if` and `unless`; launch takes one of them")


def substitution_faults(text: LaunchText) -> Iterator[Fault]:
    """Yield what is wrong with the names of substitutions, and with the number of their arguments."""
    for found in text.substitutions():
        count = len(found.arguments)
        if found.name not in SUBSTITUTIONS:
            meant = nearest(found.name, SUBSTITUTIONS, 1)
            if meant:
                yield Fault(found.span, f"launch has no substitution `$({found.name} …)`; did you mean `$({meant} …)`?")
            continue
        least, most = SUBSTITUTIONS[found.name]
        if not least <= count <= most:
            wanted = str(least) if least == most else f"{least} to {most}"
            message = f"`$({found.name} …)` takes {wanted} argument{'s' * (most != 1)}, not {count}"
            yield Fault(found.span, f"{message}; quote an argument that holds blanks")


def forgotten_substitutions(root: Entity, used: frozenset[str]) -> Iterator[Fault]:
    """Yield `<param name="x" value="x"/>` where `x` is an argument of the file that is used nowhere."""
    declared = {
        each.attributes["name"].text for each in root.walk() if each.name == "arg" and "name" in each.attributes
    }
    for each in root.walk():
        name, value = each.attributes.get("name"), each.attributes.get("value")
        if each.name == "param" and name and value and name.text == value.text and name.text in declared - used:
            message = f"the parameter is the text `{value.text}`, not the argument of that name, which nothing asks for"
            yield Fault(value.span, f"{message}; write `$(var {value.text})`")
