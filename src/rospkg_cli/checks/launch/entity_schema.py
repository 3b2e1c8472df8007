"""LCH007: what the XML and YAML frontends refuse: syntax, unknown or misplaced entities and attributes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...light_dataclasses import replace
from ...package.launch.entity import Entity
from ...package.launch.launch_file import LaunchFile
from ...ros.launch_entities import ACTIONS, INCLUDE_ARGUMENT, PARTS, ROS1_ENTITIES, ROS1_ONLY, EntityKind
from ...suggest import did_you_mean, nearest
from ..fault import Fault
from ..read_sentences import syntax_sentence
from .entity_values import quoted_arguments, substitution_faults, without_dollar

AS_IN_PYTHON = {"executable": "exec", "package": "pkg", "default_value": "default", "condition": "if"}
"""Arguments of actions in Python that are called otherwise in XML and YAML."""
WHOLE = ": launch refuses the whole file"
SHOWN = 3
"""Names of entities in one message."""


def entity_faults(file: LaunchFile) -> Iterator[Fault]:
    """Yield what launch refuses in an XML or YAML launch file; nothing in one for ROS 1."""
    if file.root is None or file.is_ros1:
        return
    for problem in file.syntax_problems:
        yield Fault(problem.span, syntax_sentence(problem))
    for child in file.root.children:
        yield from action_faults(child)
    for each in file.substitutions:
        yield from substitution_faults(each)
    used = {each.arguments[0].literal or "" for each in file.configurations() if each.arguments}
    yield from quoted_arguments(file.root, frozenset(used))
    yield from without_dollar(file)


def with_entity_names(file: LaunchFile, faults: Iterable[Fault]) -> Iterator[Fault]:
    """Yield faults with the `name` of the entity they are in, where it has one: a file may have many `arg`."""
    names = {
        span: written.text
        for entity in (file.root.walk() if file.root else ())
        if (written := entity.attributes.get("name")) and written.text and "$(" not in written.text
        for span in (entity.name_span, *entity.attribute_spans.values())
    }
    for fault in faults:
        places = (fault.span, *(span for span, _ in fault.related))
        found = dict.fromkeys(name for span in places if (name := names.get(span)) and f"`{name}`" not in fault.message)
        shown = ", ".join(f"`{name}`" for name in list(found)[:SHOWN]) + ", …" * (len(found) > SHOWN)
        message = fault.message.replace(WHOLE, f", at {shown}{WHOLE}") if found else fault.message
        yield replace(fault, message=message)


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
        elif not kind.open and not (entity.name == "node" and child.name in ROS1_ENTITIES):  # LCH006 reports those
            hint = did_you_mean(child.name, kind.inside)
            message = f"`{child.name}` is not allowed inside `{entity.name}`{hint}: launch refuses the whole file"
            yield Fault(child.name_span, message)


def unknown_action(entity: Entity) -> Iterator[Fault]:
    """Yield an unknown action that is one letter from a known one: packages add actions of their own."""
    near = nearest(entity.name, ACTIONS, 1)
    if near and entity.name not in ROS1_ONLY and entity.name not in PARTS:
        yield Fault(entity.name_span, f"launch has no action `{entity.name}`; did you mean `{near}`?")


def part_faults(entity: Entity, parent: str) -> Iterator[Fault]:
    kind = INCLUDE_ARGUMENT if parent == "include" else PARTS[entity.name]
    yield from attribute_faults(entity, kind)
    if entity.name == "param":
        yield from parameter_faults(entity, is_nested=parent == "param")
    for child in entity.children:
        if child.name in kind.inside:
            yield from part_faults(child, entity.name)
        else:
            yield Fault(child.name_span, f"`{child.name}` is not allowed inside `{entity.name}`")


def parameter_faults(entity: Entity, *, is_nested: bool) -> Iterator[Fault]:
    """Yield why launch_ros refuses a `<param>`: a file, or a name with a value or others inside (actions/node.py)."""
    given = entity.attribute_spans.keys()
    what = f"the parameter `{entity.attributes['name'].text}`" if "name" in entity.attributes else "`param`"
    if any(nearest(name, PARTS["param"].attributes) for name in given - PARTS["param"].attributes):
        return
    values = [name for name in ("value", "param") if name in given or (name == "param" and entity.named("param"))]
    message = ""
    if "name" in given and "from" in given:
        message = f"{what} has `name` and `from`, and launch takes one of them"
    elif "name" not in given and (is_nested or "from" not in given):
        message = "`param` has no `name`" + ("" if is_nested else " and no `from`")
    elif "name" in given and not values:
        message = f"{what} has no `value`"
    elif len(values) > 1:
        message = f"{what} has a `value` and parameters inside, and launch takes one of them"
    if message:
        yield Fault(entity.name_span, f"{message}: launch refuses the whole file")


def attribute_faults(entity: Entity, kind: EntityKind) -> Iterator[Fault]:
    given, intended = entity.attribute_spans, set()
    if entity.name == "node" and "type" in given:
        given = {**given, "exec": given["type"]}
        del given["type"]
    for name, span in given.items():
        if not kind.takes(name) and name not in kind.inside and not (kind.actions and name == "children"):
            in_python = AS_IN_PYTHON.get(name, "")
            near = in_python if in_python in kind.attributes else nearest(name, kind.attributes | kind.inside)
            intended.add(near)
            hint = f" (did you mean `{near}`?)" if near else ""
            message = f"`{entity.name}` has no attribute `{name}`{hint}: launch refuses the whole file"
            yield Fault(span, message)
    for name in sorted(kind.required - given.keys() - intended):
        yield Fault(entity.name_span, f"`{entity.name}` lacks its attribute `{name}`: launch refuses the whole file")
    if {"if", "unless"} <= given.keys():
        yield Fault(given["unless"], f"`{entity.name}` has `if` and `unless`; launch takes one of them")
