"""Read XML with expat, in linear time, keeping the exact span of every element, attribute, text and comment."""

from __future__ import annotations

from xml.parsers import expat

from ...lazy_regex import regex
from ...read_problem import ReadProblem
from ...source import Source, Span
from ...unreadable import UnreadableError
from ..char_table import CharTable
from .elements import Attribute as Attribute
from .elements import Document as Document
from .elements import Element as Element
from .elements import Instruction as Instruction
from .elements import XmlComment as XmlComment
from .errors import describe_error

MAX_DEPTH = 200
"""Deeper documents are refused; libxml2 stops at 256."""

MAX_ATTRIBUTES = 1_000
"""Of one element."""

MAX_ELEMENTS = 50_000
"""Comments count too."""

ATTRIBUTE = regex(r"""\s+([^\s=<>"'/]+)\s*=\s*(?:"([^"]*)"|'([^']*)')""")
QUALIFIED = regex(r"[^:]+(:[^:]+)?")
BOUND = frozenset({"xml", "xmlns"})


VALUE = regex(r'="[^"]*"')
STAND_IN = "\x7f"
"""A character of one byte that XML allows and no file has; it takes the place of a `<`."""


def read_xml(source: Source, *, prefixes: bool = True, takes_less_than: bool = False) -> Document:
    """Parse a decoded text; raises UnreadableError at the exact position where it is not well formed.

    Without `prefixes` a prefix that nothing declares is a part of a name, as it is for TinyXML. It also takes a `<` in
    the value of an attribute, as this does with `takes_less_than`.
    """
    return XmlParser(source, prefixes, takes_less_than).read()


class XmlParser:
    """One pass of expat over the text."""

    def __init__(self, source: Source, prefixes: bool, takes_less_than: bool = False) -> None:
        self.source, self.prefixes = source, prefixes
        self.is_replaced = takes_less_than and STAND_IN not in source.text
        text = (
            VALUE.sub(lambda found: found[0].replace("<", STAND_IN), source.text) if self.is_replaced else source.text
        )
        self.data = text.encode("utf-8", "surrogatepass")
        self.chars = CharTable(source.text) if len(self.data) != len(source.text) else None
        self.parser = expat.ParserCreate("utf-8")
        top = Span(0, len(source.text))
        self.stack = [Element("", top, Span(0, 0), top)]
        self.bound = [BOUND]
        self.elements = 0
        self.instructions: list[Instruction] = []
        self.comments: list[XmlComment] = []

    def read(self) -> Document:
        if (at := self.source.text.find("\0")) >= 0:  # expat would guess another encoding from it
            self.fail(at, ReadProblem.XML_NUL)
        parser = self.parser
        parser.buffer_text = True
        parser.StartElementHandler, parser.EndElementHandler = self.start, self.end
        parser.CharacterDataHandler = self.characters
        parser.CommentHandler, parser.ProcessingInstructionHandler = self.comment, self.instruction
        parser.StartDoctypeDeclHandler = self.doctype
        try:
            parser.Parse(self.data, True)
        except expat.ExpatError as error:
            inside = self.stack[-1]
            at = self.char(parser.ErrorByteIndex)
            at, problem = describe_error(self.source, error.code, at, inside.tag, inside.span.start)
            self.fail(at, *problem)
        finally:
            del self.parser  # it has methods of this object: the two could not be freed at once
        return Document(self.source, self.stack[0].children[0], self.instructions, self.comments)

    def char(self, byte: int) -> int:
        return byte if self.chars is None else self.chars[byte]

    @property
    def at(self) -> int:
        return self.char(self.parser.CurrentByteIndex)

    def fail(self, at: int, code: ReadProblem, *details: str) -> None:
        at = max(0, min(at, len(self.source.text)))
        raise UnreadableError(self.source.path, Span(at, min(at + 1, len(self.source.text))), code, *details)

    def skip(self, at: int, code: ReadProblem, *details: str) -> None:
        raise UnreadableError(self.source.path, Span(at, at + 1), code, *details, skipped=True)

    def count(self, at: int) -> None:
        """Refuse more elements and comments than readers can process in some seconds."""
        self.elements += 1
        if self.elements > MAX_ELEMENTS:
            self.skip(at, ReadProblem.XML_LENGTH, f"{MAX_ELEMENTS:,}")

    def start(self, tag: str, attributes: dict[str, str]) -> None:
        at = self.at
        if len(attributes) > MAX_ATTRIBUTES:
            self.skip(at, ReadProblem.XML_ATTRIBUTES, tag[:40], f"{MAX_ATTRIBUTES:,}")
        if self.is_replaced:
            attributes = {name: value.replace(STAND_IN, "<") for name, value in attributes.items()}
        found, end = start_tag(self.source.text, at + 1 + len(tag), attributes)
        element = Element(tag, Span(at, end), Span(at, end), Span(end, end), found)
        if len(self.stack) > MAX_DEPTH:
            self.fail(at, ReadProblem.XML_DEPTH, str(MAX_DEPTH))
        self.count(at)
        declared = [name[6:] for name in attributes if name.startswith("xmlns:")]
        self.bound.append(self.bound[-1].union(declared) if declared else self.bound[-1])
        for name in (tag, *attributes):
            if self.prefixes and ":" in name:
                self.check_prefix(name, at)
        self.stack[-1].nodes.append(element)
        self.stack.append(element)

    def check_prefix(self, name: str, at: int) -> None:
        """Refuse a prefix that no `xmlns:` declares, as every reader with namespaces does."""
        prefix = name.partition(":")[0]
        if not QUALIFIED.fullmatch(name) or prefix not in self.bound[-1]:
            self.fail(at, ReadProblem.XML_PREFIX, name, prefix)

    def end(self, tag: str) -> None:
        element, at, text = self.stack.pop(), self.at, self.source.text
        self.bound.pop()
        if text[element.open.end - 2] != "/":
            element.inner = Span(element.open.end, at)
            element.span = Span(element.span.start, text.index(">", at) + 1)

    def characters(self, chunk: str) -> None:
        self.stack[-1].chunks.append(chunk)

    def comment(self, text: str) -> None:
        at = self.at
        self.count(at)
        found = XmlComment(text, Span(at, self.source.text.index("-->", at + 4) + 3))
        self.comments.append(found)
        self.stack[-1].nodes.append(found)

    def instruction(self, target: str, data: str) -> None:
        at = self.at
        self.instructions.append(Instruction(target, data, Span(at, self.source.text.index("?>", at) + 2)))

    def doctype(self, *_: object) -> None:
        at = max(self.source.text.rfind("<!DOCTYPE", 0, self.at + 9), 0)
        self.fail(at, ReadProblem.XML_DOCTYPE)


def start_tag(text: str, at: int, values: dict[str, str]) -> tuple[dict[str, Attribute], int]:
    """Return the attributes of a well-formed start tag, and the end of the tag."""
    found: dict[str, Attribute] = {}
    while match := ATTRIBUTE.match(text, at):
        name, group = match.group(1), 2 if match.group(2) is not None else 3
        spans = Span(match.start(1), match.end()), Span(*match.span(group))
        found[name] = Attribute(name, values[name], *spans)
        at = match.end()
    return found, text.index(">", at) + 1
