"""Blank lines and headings of sorted children: paragraphs stay together, headings come before the first of a tag."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

from ..ros.manifest import DEPENDENCY_TAGS
from .manifest_items import Item


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
    """Return the items in groups that are separated by blank lines."""
    found: list[list[Item]] = []
    for item in items:
        if item.begins_paragraph or not found:
            found.append([])
        found[-1].append(item)
    return found


def tidy_paragraphs(
    order: Sequence[Item], fresh: set[Item], leads: dict[Item, str], swap: Callable[[Item, Item], None]
) -> None:
    """Among items with a new neighbour (`fresh`), move headings to the first of a tag, and blank lines to where the tag
    changes.
    """
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
