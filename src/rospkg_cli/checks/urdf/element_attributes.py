"""Attributes of URDF elements that urdfdom reads as numbers or vectors, and the values that it refuses."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.xml.parser import Attribute, Element
from ...lazy_regex import regex
from ...source import Source, Span
from ..fault import Fault
from .numbers import is_number, vector_fault

SPACE = regex(r"[\t\r\n]")
VECTORS = {"xyz": 3, "rpy": 3, "size": 3, "scale": 3}


class AttributeCheck:
    """Checks the attributes of single elements; what xacro fills in counts as right."""

    def __init__(self, source: Source, *, is_xacro: bool = False) -> None:
        self.source = source
        self.is_xacro = is_xacro

    def origin(self, element: Element) -> Iterator[Fault]:
        if (origin := first(element, "origin")) is not None:
            yield from self.vectors(origin, ("xyz", "rpy"))

    def vectors(self, element: Element, names: tuple[str, ...]) -> Iterator[Fault]:
        """Yield the attributes of some names that do not hold as many numbers as they must."""
        for name in names:
            found = element.attributes.get(name)
            if found is not None and (text := self.raw(found)) is not None:
                fault = vector_fault(text, VECTORS[name])
                if fault:
                    yield Fault(found.value_span, f"`{name}` of `<{element.tag}>` can't be read: {fault}")

    def numbers(self, element: Element, needed: tuple[str, ...], possible: tuple[str, ...]) -> Iterator[Fault]:
        """Yield the needed attributes that are missing, and all that are no number."""
        missing = [f"`{name}`" for name in needed if name not in element.attributes]
        if missing and not fills(element):
            yield Fault(element.open, f"`<{element.tag}>` has no {', '.join(missing)}")
        for name in (*needed, *possible):
            found = element.attributes.get(name)
            if found is None:
                continue
            if (text := self.raw(found)) is not None and not is_number(text):
                yield Fault(found.value_span, f"`{name}` of `<{element.tag}>` is no number: `{text}`")

    def raw(self, attribute: Attribute) -> str | None:
        """Return a value as urdfdom gets it; None where xacro fills it in.

        The parser of xacro turns tabs and line ends into blanks; urdfdom does not.
        """
        text = self.source.slice(attribute.value_span)
        text = SPACE.sub(" ", text) if self.is_xacro else text
        return None if "$" in text else text


def first(element: Element, tag: str) -> Element | None:
    return next((child for child in element.children if child.tag == tag), None)


def fills(element: Element) -> bool:
    """Return whether xacro may add children or attributes to an element."""
    makes = any(":" in child.tag and child.tag != "xacro:property" for child in element.children)
    return makes or any("xacro:" in name for name in element.attributes)


def name_span(element: Element) -> Span:
    """Return where the name of an element is written; its tag where it has none."""
    found = element.attributes.get("name")
    return found.value_span if found else element.open
