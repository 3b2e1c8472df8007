"""The children of <package>, each with the comments and blanks that belong to it."""

from __future__ import annotations

from collections.abc import Sequence

from ..languages.xml.elements import Element, XmlComment
from ..light_dataclasses import dataclass
from ..package.manifest import Manifest
from ..source import Span


@dataclass(frozen=True, eq=False)
class Item:
    """A child with the comments that are about it."""

    element: Element
    span: Span
    lead: str
    """The text between the item before and this one: blanks, and comments that belong to neither."""

    @property
    def begins_paragraph(self) -> bool:
        return self.lead.count("\n") > 1


def items_of(manifest: Manifest) -> list[Item]:
    """Return the children in document order, with the comments directly above them and behind them in the same line."""
    text, nodes = manifest.source.text, manifest.root.nodes
    items: list[Item] = []
    end = manifest.root.open.end
    index = 0
    while index < len(nodes):
        start = index
        while index < len(nodes) and isinstance(nodes[index], XmlComment):
            index += 1
        if index == len(nodes):
            break
        element = nodes[index]
        assert isinstance(element, Element)
        index += 1
        span = Span(lead_start(text, nodes[start:index]), element.span.end)
        while index < len(nodes) and trailing_comment(text, span.end, nodes[index]):
            span = Span(span.start, nodes[index].span.end)
            index += 1
        span = Span(span.start, line_end(text, span.end))
        items.append(Item(element, span, text[end : span.start]))
        end = span.end
    return items


def line_end(text: str, at: int) -> int:
    """Return where blanks at the end of a line end; `at` where something else is behind it."""
    end = len(text) - len(text[at:].lstrip(" \t"))
    return end if text.startswith(("\n", "\r\n"), end) else at


def trailing_comment(text: str, end: int, node: Element | XmlComment) -> bool:
    return isinstance(node, XmlComment) and "\n" not in text[end : node.span.start]


def lead_start(text: str, nodes: Sequence[Element | XmlComment]) -> int:
    """Return where an item begins: at the first of the comments right above its element."""
    start = nodes[-1].span.start
    for comment in reversed(nodes[:-1]):
        if text.count("\n", comment.span.end, start) > 1:
            break
        start = comment.span.start
    return start


def has_content(lead: str) -> bool:
    """Return whether a span holds anything but blanks and comments."""
    while "<!--" in lead:
        before, _, rest = lead.partition("<!--")
        lead = before + rest.partition("-->")[2]
    return bool(lead.strip(" \t\r\n"))
