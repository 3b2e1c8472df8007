"""What the XML and the YAML frontend have in common: a tree of entities with attributes."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.located_text import LocatedText
from ...languages.syntax_problem import SyntaxProblem
from ...languages.xml.parser import Document, Element, read_xml
from ...languages.yaml.aliases import read_resolved
from ...languages.yaml.nodes import MappingNode, ScalarNode, SequenceNode, YamlNode
from ...light_dataclasses import dataclass, field
from ...read_problem import ReadProblem
from ...source import Source, Span


@dataclass(frozen=True)
class Entity:
    name: str
    span: Span
    name_span: Span
    attributes: dict[str, LocatedText] = field(default_factory=dict)
    attribute_spans: dict[str, Span] = field(default_factory=dict)
    """Of the names."""
    lists: dict[str, tuple[LocatedText, ...]] = field(default_factory=dict)
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
            a.name: LocatedText(a.value, a.value_span, text[a.value_span.start : a.value_span.end] == a.value)
            for a in element.attributes.values()
        },
        {a.name: Span(a.span.start, a.span.start + len(a.name)) for a in element.attributes.values()},
        children=tuple(xml_entity(document, child) for child in element.children),
    )


def from_yaml(source: Source) -> tuple[Entity | None, list[SyntaxProblem]]:
    """Read a YAML file, and what the frontend refuses of it; raises UnreadableError for what is no YAML."""
    root = read_resolved(source)
    entries = pairs(root) if isinstance(root, MappingNode) else []
    if not entries:
        return None, []
    problems: list[SyntaxProblem] = []
    if len(entries) > 1:
        problems.append(SyntaxProblem(entries[1][0].located.span, ReadProblem.LAUNCH_KEYS))
    key, value = entries[0]
    return yaml_entity(key, value, problems), problems


def pairs(mapping: MappingNode) -> list[tuple[ScalarNode, YamlNode]]:
    """Return the entries of a mapping whose keys are scalars."""
    return [(key, value) for key, value in mapping.entries if isinstance(key, ScalarNode)]


def yaml_entity(name: ScalarNode, value: YamlNode, problems: list[SyntaxProblem]) -> Entity:
    """Make an entity of `name: value`."""
    span = name.located.span
    found = Entity(name.text, Span(span.start, value.span.end), span)
    if isinstance(value, SequenceNode):
        return with_children(found, list(children_of(value.items, problems)))
    children: list[Entity] = []
    for key, item in pairs(value) if isinstance(value, MappingNode) else []:
        found.attribute_spans[key.text] = key.located.span
        if isinstance(item, ScalarNode):
            found.attributes[key.text] = item.located
        elif key.text == "children":
            children += children_of(values_of(item), problems)
        elif isinstance(item, SequenceNode) and not all(isinstance(each, ScalarNode) for each in item.items):
            children += [yaml_entity(key, each, problems) for each in item.items]
        else:
            found.lists[key.text] = tuple(each.located for each in values_of(item) if isinstance(each, ScalarNode))
    return with_children(found, children)


def values_of(node: YamlNode) -> list[YamlNode]:
    """Return the items of a sequence, or the values of a mapping."""
    if isinstance(node, MappingNode):
        return [value for _, value in pairs(node)]
    return node.items if isinstance(node, SequenceNode) else []


def children_of(items: list[YamlNode], problems: list[SyntaxProblem]) -> Iterator[Entity]:
    """Yield the entities of a list in which each item is `name: value`."""
    for item in items:
        entries = pairs(item) if isinstance(item, MappingNode) else []
        if not entries:
            span = item.located.span if isinstance(item, ScalarNode) else item.span
            problems.append(SyntaxProblem(span, ReadProblem.LAUNCH_ENTRY))
            continue
        key, value = entries[0]
        yield yaml_entity(key, value, problems)
        if len(entries) > 1:
            extra = entries[1][0]
            names = (extra.text, key.text)
            problems.append(SyntaxProblem(extra.located.span, ReadProblem.LAUNCH_TWO_IN_ONE, names))


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
