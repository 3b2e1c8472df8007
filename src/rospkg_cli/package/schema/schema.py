"""Validate package.xml by the schema of its format: libxml2 gives the verdict, xmlschema the reasons.

Neither library is imported before validation, nor xmlschema before libxml2 has refused the document.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterable
from functools import cache
from typing import Any, TypeVar

from ...languages.xml.elements import Document, Element
from ...light_dataclasses import dataclass
from ...resources import resources
from ...ros.manifest import ORDER, place_of
from .plainly_valid import is_plainly_valid
from .violation import Violation

Item = TypeVar("Item")


@dataclass(frozen=True)
class Verdict:
    is_valid: bool
    is_ordered: bool = True
    """Whether the children are in the schema's order, whatever else is wrong."""
    violations: tuple[Violation, ...] = ()
    """The violations that sorting the children does not fix, in document order."""


VALID = Verdict(True)


def validate(document: Document, format: int) -> Verdict:
    """Validate by the schema of a format (1, 2, 3); children in a wrong order are no violation by themselves."""
    if is_plainly_valid(document, format) or accepts(document.source.text, format):
        return VALID
    ordered = not misplaced(document.root.children)
    if not ordered and accepts(document.source.text, format, in_order=True):
        return Verdict(False, ordered)
    from .schema_explain import explain

    return Verdict(False, ordered, explain(document, format))


def accepts(text: str, format: int, in_order: bool = False) -> bool:
    """Return libxml2's verdict on a well-formed text, or on a copy of it whose children are put in order."""
    from lxml import etree

    parser = etree.XMLParser(encoding="utf-8", resolve_entities=False, no_network=True, remove_comments=True)
    try:
        root = etree.fromstring(text.encode("utf-8", "surrogatepass"), parser)
    except etree.XMLSyntaxError:  # a limit of libxml2 that expat doesn't have
        return False
    if in_order:
        root[:] = sorted((child for child in root if isinstance(child.tag, str)), key=by_place(lambda c: str(c.tag)))
    return bool(libxml2_schema(format).validate(root))


def by_place(tag: Callable[[Item], str]) -> Callable[[Item], int]:
    return lambda item: place_of(tag(item))


@cache
def libxml2_schema(format: int) -> Any:
    from lxml import etree

    return etree.XMLSchema(etree.parse(str(resources("schemas") / f"package_format{format}.xsd")))


def misplaced(children: Iterable[Element]) -> list[Element]:
    """Return the fewest children that have to move so that all are in the schema's order.

    Tags that it doesn't know have no place in it.
    """
    found = [child for child in children if place_of(child.tag) < len(ORDER)]
    kept = longest_run([place_of(child.tag) for child in found])
    return [child for index, child in enumerate(found) if index not in kept]


def longest_run(places: list[int]) -> set[int]:
    """Return the indices of a longest subsequence that never falls (by patience sorting, n log n)."""
    ends: list[int] = []  # the place that ends the best run of each length
    last: list[int] = []  # its index
    before: list[int] = []  # for each index, the one before it in its run
    for index, place in enumerate(places):
        length = bisect_right(ends, place)
        before.append(last[length - 1] if length else -1)
        ends[length : length + 1] = [place]
        last[length : length + 1] = [index]
    kept: set[int] = set()
    at = last[-1] if last else -1
    while at >= 0:
        kept.add(at)
        at = before[at]
    return kept
