"""Read XML with expat, in linear time, keeping the exact span of every element, attribute, text and comment."""

from __future__ import annotations

import re
from array import array
from collections.abc import Iterator
from dataclasses import dataclass, field
from xml.parsers import expat

from ..source import Source, Span
from .unreadable import UnreadableError

MAX_DEPTH = 200
ATTRIBUTE = re.compile(r"""\s+([^\s=<>"'/]+)\s*=\s*(?:"([^"]*)"|'([^']*)')""")


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
class Comment:
    text: str
    span: Span


@dataclass(slots=True)
class Element:
    tag: str
    span: Span
    """From `<` to the last `>`."""
    open: Span
    """The start tag."""
    inner: Span
    """Between start tag and end tag; empty at the end of a self-closing tag."""
    attributes: dict[str, Attribute] = field(default_factory=dict)
    nodes: list[Element | Comment] = field(default_factory=list)
    """Child elements and comments, in order."""
    chunks: list[str] = field(default_factory=list)

    @property
    def children(self) -> list[Element]:
        return [node for node in self.nodes if isinstance(node, Element)]

    @property
    def self_closing(self) -> bool:
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
        yield self
        for child in self.children:
            yield from child.walk()


@dataclass
class Document:
    source: Source
    root: Element
    instructions: list[tuple[str, str, Span]]
    """Processing instructions: target, data, span."""
    comments: list[Comment]
    """All of them, wherever they stand."""

    def text_span(self, element: Element) -> Span:
        """Return the span of what stands between the tags, without the blanks around it."""
        raw = self.source.slice(element.inner)
        start = element.inner.start + len(raw) - len(raw.lstrip())
        return Span(start, start + len(raw.strip())) if raw.strip() else element.span


def read_xml(source: Source) -> Document:
    """Parse a decoded text; raises UnreadableError at the exact place where it is not well formed."""
    return Reader(source).read()


class Reader:
    """One pass of expat over the text."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.data = source.text.encode("utf-8", "surrogatepass")
        self.chars = char_table(source.text) if len(self.data) != len(source.text) else None
        self.parser = expat.ParserCreate("utf-8")
        top = Span(0, len(source.text))
        self.stack = [Element("", top, Span(0, 0), top)]
        self.instructions: list[tuple[str, str, Span]] = []
        self.comments: list[Comment] = []

    def read(self) -> Document:
        parser = self.parser
        parser.StartElementHandler, parser.EndElementHandler = self.start, self.end
        parser.CharacterDataHandler = self.characters
        parser.CommentHandler, parser.ProcessingInstructionHandler = self.comment, self.instruction
        parser.StartDoctypeDeclHandler = self.doctype
        try:
            parser.Parse(self.data, True)
        except expat.ExpatError as error:
            self.fail(self.char(parser.ErrorByteIndex), self.explain(error))
        return Document(self.source, self.stack[0].children[0], self.instructions, self.comments)

    def char(self, byte: int) -> int:
        return byte if self.chars is None else self.chars[byte]

    @property
    def at(self) -> int:
        return self.char(self.parser.CurrentByteIndex)

    def fail(self, at: int, why: str) -> None:
        at = min(at, len(self.source.text))
        raise UnreadableError(self.source.path, Span(at, min(at + 1, len(self.source.text))), why)

    def explain(self, error: expat.ExpatError) -> str:
        said = expat.ErrorString(error.code).replace("not well-formed (invalid token)", "an unexpected character")
        inside = f", inside `<{self.stack[-1].tag}>`" if len(self.stack) > 1 else ""
        return f"`{self.source.path}` is not well-formed XML: {said}{inside}"

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        at = self.at
        found, end = start_tag(self.source.text, at + 1 + len(tag), attributes)
        element = Element(tag, Span(at, end), Span(at, end), Span(end, end), found)
        if len(self.stack) > MAX_DEPTH:
            self.fail(at, f"`{self.source.path}` is nested deeper than {MAX_DEPTH} elements")
        self.stack[-1].nodes.append(element)
        self.stack.append(element)

    def end(self, tag: str) -> None:
        element, at, text = self.stack.pop(), self.at, self.source.text
        if text[element.open.end - 2] != "/":
            element.inner = Span(element.open.end, at)
            element.span = Span(element.span.start, text.index(">", at) + 1)

    def characters(self, chunk: str) -> None:
        self.stack[-1].chunks.append(chunk)

    def comment(self, text: str) -> None:
        at = self.at
        found = Comment(text, Span(at, self.source.text.index("-->", at + 4) + 3))
        self.comments.append(found)
        self.stack[-1].nodes.append(found)

    def instruction(self, target: str, data: str) -> None:
        at = self.at
        self.instructions.append((target, data, Span(at, self.source.text.index("?>", at) + 2)))

    def doctype(self, *_: object) -> None:
        self.fail(self.at, f"`{self.source.path}` has a DOCTYPE; entities and document types are not read: remove it")


def start_tag(text: str, at: int, values: dict[str, str]) -> tuple[dict[str, Attribute], int]:
    """Return the attributes of a well-formed start tag, and the end of the tag."""
    found: dict[str, Attribute] = {}
    while match := ATTRIBUTE.match(text, at):
        name, group = match.group(1), 2 if match.group(2) is not None else 3
        spans = Span(match.start(1), match.end()), Span(*match.span(group))
        found[name] = Attribute(name, values[name], *spans)
        at = match.end()
    return found, text.index(">", at) + 1


def char_table(text: str) -> array[int]:
    """Return, for each byte of the UTF-8 text and its end, the index of the character it belongs to."""
    table = array("I")
    for index, char in enumerate(text):
        table.extend([index] * len(char.encode("utf-8", "surrogatepass")))
    table.append(len(text))
    return table
