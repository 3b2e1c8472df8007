"""An XML document whose every element, attribute, text and comment knows its exact span."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass, field
from ...source import Source, Span


@dataclass(slots=True)
class Attribute:
    name: str
    value: str
    """With references resolved."""
    span: Span
    """From the name to the closing quote."""
    value_span: Span
    """Between the quotes."""


@dataclass(slots=True)
class XmlComment:
    text: str
    span: Span


@dataclass(slots=True)
class Instruction:
    """A processing instruction, `<?target data?>`."""

    target: str
    data: str
    span: Span


@dataclass(slots=True, eq=False)
class Element:
    """Elements are compared by identity."""

    tag: str
    span: Span
    """From `<` to the last `>`."""
    open: Span
    """The start tag."""
    inner: Span
    """Between start tag and end tag; empty at the end of a self-closing tag."""
    attributes: dict[str, Attribute] = field(default_factory=dict)
    nodes: list[Element | XmlComment] = field(default_factory=list)
    """Child elements and comments, in order."""
    chunks: list[str] = field(default_factory=list)

    @property
    def children(self) -> list[Element]:
        return [node for node in self.nodes if isinstance(node, Element)]

    @property
    def is_self_closing(self) -> bool:
        return self.open.end == self.span.end

    @property
    def text(self) -> str:
        """The character data directly inside, stripped."""
        return "".join(self.chunks).strip()

    def get(self, name: str) -> str | None:
        found = self.attributes.get(name)
        return None if found is None else found.value

    def walk(self) -> Iterator[Element]:
        """Yield this element and all below it, in document order."""
        waiting = [self]
        while waiting:
            element = waiting.pop()
            yield element
            waiting.extend(reversed(element.children))


@dataclass
class Document:
    source: Source
    root: Element
    instructions: list[Instruction]
    comments: list[XmlComment]
    """All comments of the document."""

    def text_span(self, element: Element) -> Span:
        """Return the span of the text between the tags, without the blanks around it."""
        raw = self.source.slice(element.inner)
        start = element.inner.start + len(raw) - len(raw.lstrip())
        return Span(start, start + len(raw.strip())) if raw.strip() else element.span
