"""YAML as a tree with spans of characters: libyaml's events with their anchors, aliases, styles and tags.

Aliases are not replaced, for not every reader does so (rcl does not); see `aliases`.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from ...light_dataclasses import dataclass, field
from ...read_problem import ReadProblem
from ...source import Source, Span
from ...unreadable import UnreadableError
from ..located_text import LocatedText

MAX_DEPTH = 100
NOWHERE = LocatedText("", Span(0, 0), False)


@dataclass(frozen=True, slots=True)
class ScalarNode:
    text: str
    span: Span
    """As written in the file: with quotes, and with an anchor or a tag before it."""
    is_plain: bool
    """Neither quoted nor a block."""
    is_quoted: bool = False
    tag: str | None = None
    anchor: str | None = None
    located: LocatedText = NOWHERE
    """The text where it stands, between the quotes where there are any."""


@dataclass(frozen=True, slots=True)
class AliasNode:
    name: str
    span: Span


@dataclass(slots=True)
class SequenceNode:
    span: Span
    items: list[YamlNode] = field(default_factory=list)
    anchor: str | None = None


@dataclass(slots=True)
class MappingNode:
    span: Span
    """Of a mapping in braces; else from its first key to where the next thing begins."""
    entries: list[tuple[YamlNode, YamlNode]] = field(default_factory=list)
    anchor: str | None = None


YamlNode = ScalarNode | AliasNode | SequenceNode | MappingNode


def documents(source: Source) -> list[YamlNode]:
    """Return the root of every document of a file that is not empty; raises UnreadableError for invalid YAML."""
    builder = NodeBuilder(source)
    for event in events(source):
        builder.take(event)
    return builder.roots


def events(source: Source) -> Iterator[Any]:
    import yaml  # 22 ms that a package without YAML need not pay

    loader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    try:
        yield from yaml.parse(source.text, Loader=loader)
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None) or getattr(error, "context_mark", None)
        at = mark.index if mark else getattr(error, "position", 0)
        said = getattr(error, "problem", None) or getattr(error, "reason", None)
        at = min(at, len(source.text))
        span = Span(at, min(at + 1, len(source.text)))
        code, details = (ReadProblem.YAML_SYNTAX, (str(said),)) if said else (ReadProblem.YAML_UNREADABLE, ())
        if source.slice(span) == "\t":
            code, details = ReadProblem.YAML_TAB, ()
        raise UnreadableError(source.path, span, code, *details) from None


class NodeBuilder:
    """Builds nodes from events without recursion, so that any depth is possible."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.roots: list[YamlNode] = []
        self.open: list[SequenceNode | MappingNode] = []
        self.keys: list[YamlNode | None] = []

    def take(self, event: Any) -> None:
        name, span = type(event).__name__, Span(event.start_mark.index, event.end_mark.index)
        if name == "ScalarEvent":
            quoted = event.style in ("'", '"')
            plain, written = not quoted and event.style not in ("|", ">"), self.written(event.value, span, quoted)
            self.put(ScalarNode(event.value, span, plain, quoted, event.tag, event.anchor, written))
        elif name == "AliasEvent":
            self.put(AliasNode(event.anchor, span))
        elif name in ("SequenceStartEvent", "MappingStartEvent"):
            if len(self.open) >= MAX_DEPTH:
                raise UnreadableError(self.source.path, span, ReadProblem.YAML_DEPTH, str(MAX_DEPTH))
            node = SequenceNode(span) if name == "SequenceStartEvent" else MappingNode(span)
            node.anchor = event.anchor
            self.open.append(node)
            self.keys.append(None)
        elif name in ("SequenceEndEvent", "MappingEndEvent"):
            node = self.open.pop()
            self.keys.pop()
            node.span = Span(node.span.start, span.end)
            self.put(node)

    def written(self, text: str, span: Span, quoted: bool) -> LocatedText:
        """Return the text with its span, behind an anchor or a tag and between its quotes."""
        raw = self.source.slice(span)
        if quoted:
            inner = Span(span.start + raw.index(raw[-1]) + 1, span.end - 1)
        else:
            inner = Span(span.end - len(text), span.end) if raw.endswith(text) else span
        return LocatedText(text, inner, self.source.slice(inner) == text)

    def put(self, node: YamlNode) -> None:
        if not self.open:
            self.roots.append(node)
        elif isinstance(self.open[-1], SequenceNode):
            self.open[-1].items.append(node)
        elif self.keys[-1] is None:
            self.keys[-1] = node
        else:
            self.open[-1].entries.append((self.keys[-1], node))
            self.keys[-1] = None
