"""Reorder the children of <package>: comments move with their element, blank lines with paragraphs.

What stands between two children is kept to the last blank: what comes out is made of the same pieces in another order.
Only a child that shares its line with another one gets its own line when it moves.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

from ..finding import Edit
from ..languages.xml.elements import Element, XmlComment
from ..light_dataclasses import dataclass
from ..package.manifest import Manifest
from ..ros.manifest import DEPENDENCY_TAGS, ORDER, place_of
from ..source import Span


@dataclass(frozen=True, eq=False)
class Item:
    """A child with the comments that are about it."""

    element: Element
    span: Span
    lead: str
    """What stands between the item before and this one: blanks, and comments that are about neither."""

    @property
    def begins_paragraph(self) -> bool:
        return self.lead.count("\n") > 1


def reorder(manifest: Manifest, key: Callable[[Element], Any]) -> list[Edit]:
    """Return the edits that sort the children by a key, stably; none where they are sorted already.

    None either where there is text or an instruction between the children: it is unknown what it belongs to.
    """
    items = items_of(manifest)
    order = sorted(items, key=lambda item: key(item.element))
    if all(old is new for old, new in zip(items, order, strict=True)) or any(has_content(item.lead) for item in items):
        return []
    leads = assign_leads(items, order)
    changed = [i for i, item in enumerate(items) if item is not order[i] or item.lead != leads[i]]
    first, last = changed[0], changed[-1]
    span = Span(items[first].span.start - len(items[first].lead), items[last].span.end)
    pieces = [leads[i] + manifest.source.slice(order[i].span) for i in range(first, last + 1)]
    return [Edit(manifest.path, span, "".join(pieces))]


def schema_order(manifest: Manifest) -> Callable[[Element], Any]:
    """Return the key of the schema's order; a tag that it doesn't know stays behind the one before it."""
    places: dict[Element, int] = {}
    before = 0
    for child in manifest.root.children:
        before = place_of(child.tag) if place_of(child.tag) < len(ORDER) else before
        places[child] = before
    return lambda element: places[element]


def canonical_order(manifest: Manifest) -> Callable[[Element], Any]:
    """Return the key of the order that `rospkg format` makes: the schema's, dependencies by tag and by name."""
    place = schema_order(manifest)

    def key(element: Element) -> tuple[int, int, str, str]:
        if element.tag not in DEPENDENCY_TAGS:
            return (place(element), len(DEPENDENCY_TAGS), "", "")
        return (place(element), DEPENDENCY_TAGS.index(element.tag), element.text, element.get("condition") or "")

    return key


def sorted_in_place(manifest: Manifest, tag: str) -> Callable[[Element], Any]:
    """Return the key that sorts the elements of one tag by name, among the places that they have."""
    found = manifest.all(tag)
    places = {child: index for index, child in enumerate(manifest.root.children)}
    wanted = dict(zip(sorted(found, key=lambda e: (e.text, e.get("condition") or "")), found, strict=True))
    return lambda element: places[wanted.get(element, element)]


def items_of(manifest: Manifest) -> list[Item]:
    """Return the children with the comments right above and in the same line behind, in document order."""
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


def assign_leads(items: Sequence[Item], order: Sequence[Item]) -> list[str]:
    """Return the text before each item of the new order: the texts of the old one, each of them once."""
    leads = {item: item.lead for item in order}

    def swap(one: Item, other: Item) -> None:
        leads[one], leads[other] = leads[other], leads[one]

    position = {item: index for index, item in enumerate(order)}
    for paragraph in paragraphs(items):
        swap(paragraph[0], min(paragraph, key=lambda item: position[item]))
    at_top = next(item for item in items if leads[item] is items[0].lead)
    swap(order[0], at_top)
    before = dict(zip(items[1:], items, strict=False))
    fresh = {b for a, b in pairwise(order) if before.get(b) is not a}
    tidy_paragraphs(order, fresh, leads, swap)
    line = next((lead for lead in leads.values() if lead.count("\n") == 1 and not lead.strip()), "\n  ")
    kept = {item for item in order if "\n" in leads[item] or ("\n" not in item.lead and item not in fresh)}
    return [leads[item] if item in kept else line for item in order]


def paragraphs(items: Sequence[Item]) -> list[list[Item]]:
    """Split where a blank line stands."""
    found: list[list[Item]] = []
    for item in items:
        if item.begins_paragraph or not found:
            found.append([])
        found[-1].append(item)
    return found


def tidy_paragraphs(
    order: Sequence[Item], fresh: set[Item], leads: dict[Item, str], swap: Callable[[Item, Item], None]
) -> None:
    """Within what came together (`fresh`): a heading before the first of a tag, blank lines where the tag changes."""
    firsts = {b for a, b in pairwise(order) if a.element.tag != b.element.tag}
    first = order[0]
    for item in order[1:]:
        first = item if item in firsts else first
        if item in fresh and first in fresh and leads[item].strip() and not leads[first].strip():
            swap(first, item)
    loose = [item for item in order if item in fresh and item.element.tag in DEPENDENCY_TAGS]
    inside = [item for item in loose if item not in firsts and opens_paragraph(leads[item])]
    edges = [item for item in loose if item in firsts and leads[item].count("\n") == 1 and not leads[item].strip()]
    for item, edge in zip(inside, edges, strict=False):
        swap(item, edge)


def opens_paragraph(lead: str) -> bool:
    return lead.count("\n") > 1 and not lead.strip()
