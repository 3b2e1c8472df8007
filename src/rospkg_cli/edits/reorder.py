"""Reorder the children of <package>: comments move with their element, blank lines with paragraphs.

All text between two children is kept: the result has the same pieces in another order. Only a child that shares its
line with another one gets a line of its own when it moves.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ..finding import Edit
from ..languages.xml.elements import Element
from ..package.manifest import Manifest
from ..ros.manifest import DEPENDENCY_TAGS, ORDER, place_of
from ..source import Span
from .item_leads import assign_leads
from .manifest_items import has_content, items_of


def reorder(manifest: Manifest, key: Callable[[Element], Any]) -> list[Edit]:
    """Return the edits that sort the children by a key, stably; none where they are sorted already.

    None as well where there is text or an instruction between the children, as it is unknown what it belongs to.
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
    """Return the key of the schema's order; an unknown tag stays behind the one before it."""
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
    """Return the key that sorts the elements of one tag by name, within the places that they have."""
    found = manifest.all(tag)
    places = {child: index for index, child in enumerate(manifest.root.children)}
    wanted = dict(zip(sorted(found, key=lambda e: (e.text, e.get("condition") or "")), found, strict=True))
    return lambda element: places[wanted.get(element, element)]
