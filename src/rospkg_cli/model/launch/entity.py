"""What the XML and the YAML frontend have in common: a tree of entities with attributes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from ...source import Source, Span
from ..written import Written
from ..xml import Document, Element, read_xml
from ..yaml import Branch, Tree, compose
from .faults import Fault


@dataclass(frozen=True)
class Entity:
    name: str
    span: Span
    name_span: Span
    attributes: dict[str, Written] = field(default_factory=dict)
    attribute_spans: dict[str, Span] = field(default_factory=dict)
    """Of the names."""
    lists: dict[str, tuple[Written, ...]] = field(default_factory=dict)
    """Attributes that are a list of plain values, which YAML knows."""
    children: tuple[Entity, ...] = ()

    def named(self, *names: str) -> tuple[Entity, ...]:
        return tuple(child for child in self.children if child.name in names)

    def walk(self) -> Iterator[Entity]:
        yield self
        for child in self.children:
            yield from child.walk()


def from_xml(source: Source) -> Entity:
    """Read an XML launch file; raises UnreadableError where it is not well formed."""
    document = read_xml(source)
    return xml_entity(document, document.root)


def xml_entity(document: Document, element: Element) -> Entity:
    start, text = element.span.start + 1, document.source.text
    return Entity(
        element.tag,
        element.span,
        Span(start, start + len(element.tag)),
        {
            a.name: Written(a.value, a.value_span, text[a.value_span.start : a.value_span.end] == a.value)
            for a in element.attributes.values()
        },
        {a.name: Span(a.span.start, a.span.start + len(a.name)) for a in element.attributes.values()},
        children=tuple(xml_entity(document, child) for child in element.children),
    )


def from_yaml(source: Source) -> tuple[Entity | None, list[Fault]]:
    """Read a YAML file, and what the frontend refuses of it; raises UnreadableError for what is no YAML."""
    root = compose(source)
    if not isinstance(root, Branch) or root.kind != "mapping" or not root.items:
        return None, []
    faults: list[Fault] = []
    if len(root.items) > 1:
        faults.append(Fault(root.items[1][0].span, "a YAML launch file has one key at its top: `launch:`"))
    key, value = root.items[0]
    return yaml_entity(key.text, key.span, value, faults), faults


def yaml_entity(name: str, name_span: Span, value: Tree, faults: list[Fault]) -> Entity:
    """Make an entity of `name: value`."""
    found = Entity(name, Span(name_span.start, value.span.end), name_span)
    if not isinstance(value, Branch):
        return found
    if value.kind == "sequence":
        return with_children(found, list(children_of(value, faults)))
    children: list[Entity] = []
    for key, item in value.items:
        found.attribute_spans[key.text] = key.span
        if not isinstance(item, Branch):
            found.attributes[key.text] = item.written
        elif key.text == "children":
            children += children_of(item, faults)
        elif item.kind == "sequence" and any(isinstance(each, Branch) for _, each in item.items):
            children += [yaml_entity(key.text, key.span, each, faults) for _, each in item.items]
        else:
            found.lists[key.text] = tuple(each.written for _, each in item.items if not isinstance(each, Branch))
    return with_children(found, children)


def children_of(sequence: Branch, faults: list[Fault]) -> Iterator[Entity]:
    """Yield the entities of a list in which each item is `name: value`."""
    for _, item in sequence.items:
        if isinstance(item, Branch) and item.kind == "mapping" and len(item.items) == 1:
            key, value = item.items[0]
            yield yaml_entity(key.text, key.span, value, faults)
        elif isinstance(item, Branch) and item.kind == "mapping" and item.items:
            key, value = item.items[0]
            yield yaml_entity(key.text, key.span, value, faults)
            extra = item.items[1][0]
            message = f"`{extra.text}` stands beside `{key.text}` in one entry of the list"
            faults.append(Fault(extra.span, f"{message}; indent it below, or begin a new entry with `-`"))
        else:
            faults.append(Fault(item.span, "an entry of a launch description is `- name:` with its attributes below"))


def with_children(entity: Entity, children: list[Entity]) -> Entity:
    return Entity(
        entity.name,
        entity.span,
        entity.name_span,
        entity.attributes,
        entity.attribute_spans,
        entity.lists,
        tuple(children),
    )
