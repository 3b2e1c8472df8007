"""Why a schema refuses a package.xml: every violation, found by asking xmlschema until it reports nothing."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any
from xml.etree import ElementTree

import xmlschema

from ...languages.xml.elements import Document, Element
from ...resources import resources
from ...ros.manifest import ONCE, REQUIRED, place_of
from .violation import Violation, ViolationKind

STAND_INS = {
    "name": "<name>stand_in</name>",
    "version": "<version>1.0.0</version>",
    "description": "<description>A stand-in</description>",
    "maintainer": '<maintainer email="stand@in.org">Stand-in</maintainer>',
    "license": "<license>MIT</license>",
}
"""What is put into the copy where a required tag is missing, or has a value of the wrong shape."""

INSTANCE = "{http://www.w3.org/2001/XMLSchema-instance}"
"""Attributes of this namespace are allowed everywhere."""

BLANKS = " \t\r\n"
"""White space of XML; `str.strip` also takes others away, as the wide blank of Japanese keyboards."""

MAX_ROUNDS = 20
"""Each round takes every offender out, so that two or three are enough; more would be a bug of rospkg."""


def explain(document: Document, format: int) -> tuple[Violation, ...]:
    """Return everything that the schema forbids once the children are in order, by position in the document."""
    found = list(Explanation(document, format).violations())
    unique = {(v.kind, id(v.element), v.name): v for v in found}
    return tuple(sorted(unique.values(), key=lambda v: (v.element.span.start, v.kind is ViolationKind.MISSING, v.name)))


@cache
def schema_of(format: int) -> Any:
    return xmlschema.XMLSchema(str(resources("schemas") / f"package_format{format}.xsd"))


class Explanation:
    """A copy of the document from which each offender is removed in turn.

    Children of the copy are matched with those of the document by identity, never by their index: xmlschema counts
    comments or doesn't, and the copy is sorted.
    """

    def __init__(self, document: Document, format: int) -> None:
        self.schema = schema_of(format)
        self.package: Any = self.schema.elements["package"]
        self.types: dict[str, Any] = {each.name: each for each in self.package.type.content.iter_elements()}
        self.root = ElementTree.fromstring(document.source.text)
        self.mine: dict[ElementTree.Element, Element] = dict(zip(self.root.iter(), document.root.walk(), strict=True))
        self.root[:] = sorted(self.root, key=lambda child: place_of(child.tag))
        self.root.attrib["format"] = str(format)  # the format itself is another rule's matter

    def violations(self) -> Iterator[Violation]:
        yield from self.required()
        yield from self.containers()
        for _ in range(MAX_ROUNDS):
            errors = [(each, getattr(each, "invalid_child", None)) for each in self.schema.iter_errors(self.root)]
            if not errors:
                return
            for error, child in errors:
                yield from self.of(error, child)

    def required(self) -> Iterator[Violation]:
        """Yield missing and repeated tags, and correct the copy so that xmlschema reports the rest."""
        for tag in ONCE:
            for again in self.root.findall(tag)[1:]:
                yield Violation(ViolationKind.REPEATED, self.mine[again], tag)
                self.root.remove(again)
        for tag in REQUIRED:
            if self.root.find(tag) is None:
                yield Violation(ViolationKind.MISSING, self.mine[self.root], tag)
                self.root.append(ElementTree.fromstring(STAND_INS[tag]))
        self.root[:] = sorted(self.root, key=lambda child: place_of(child.tag))

    def containers(self) -> Iterator[Violation]:
        """Find text where only elements are allowed; xmlschema overlooks it next to a wildcard."""
        for element in (self.root, *self.root):
            xsd = self.package if element is self.root else self.types.get(element.tag)
            if xsd is not None and not xsd.type.has_mixed_content() and not xsd.type.has_simple_content():
                yield from self.text(element)

    def of(self, error: Any, child: ElementTree.Element | None) -> Iterator[Violation]:
        """Translate one error of xmlschema, and remove the offender."""
        element = error.elem
        if isinstance(error, xmlschema.XMLSchemaChildrenValidationError):
            # A known tag is in order here: its error is a consequence of one that is not known.
            if child is not None and child.tag not in self.types and child in list(self.root):
                yield Violation(ViolationKind.CHILD, self.mine[child], self.mine[child].tag)
                self.root.remove(child)
        elif element is self.root:
            yield from self.attributes(element, self.package)
        elif element.tag in self.types and element in list(self.root):
            yield from self.inside(element)

    def inside(self, element: ElementTree.Element) -> Iterator[Violation]:
        xsd = self.types[element.tag]
        yield from self.attributes(element, xsd)
        if xsd.type.has_simple_content():
            for child in list(element):
                yield Violation(ViolationKind.CHILD, self.mine[child], self.mine[child].tag)
                element.remove(child)
            simple = xsd.type.content if xsd.type.is_complex() else xsd.type
            if not simple.is_valid(element.text or ""):
                yield Violation(ViolationKind.VALUE, self.mine[element], "")
                self.replace_text(element)

    def attributes(self, element: ElementTree.Element, xsd: Any) -> Iterator[Violation]:
        for name, value in list(element.attrib.items()):
            if name.startswith(INSTANCE):
                continue
            if name not in xsd.attributes:
                yield Violation(ViolationKind.ATTRIBUTE, self.mine[element], plain(name, self.mine[element]))
            elif not xsd.attributes[name].type.is_valid(value):
                yield Violation(ViolationKind.VALUE, self.mine[element], name)
            else:
                continue
            del element.attrib[name]
        for name, attribute in xsd.attributes.items():
            if attribute.use == "required" and name not in element.attrib:
                if name not in self.mine[element].attributes:
                    yield Violation(ViolationKind.MISSING_ATTRIBUTE, self.mine[element], name)
                element.attrib[name] = ElementTree.fromstring(STAND_INS[element.tag]).attrib[name]

    def replace_text(self, element: ElementTree.Element) -> None:
        if element.tag in STAND_INS:
            element.text = ElementTree.fromstring(STAND_INS[element.tag]).text
        else:
            self.root.remove(element)

    def text(self, element: ElementTree.Element) -> Iterator[Violation]:
        """Remove the text between the children."""
        if any((each or "").strip(BLANKS) for each in (element.text, *(child.tail for child in element))):
            yield Violation(ViolationKind.TEXT, self.mine[element], "")
        element.text = None
        for child in element:
            child.tail = None


def plain(name: str, element: Element) -> str:
    """Return an attribute's name as it is written, for one that ElementTree gives as `{uri}name`."""
    local = name.rpartition("}")[2]
    written = [each for each in element.attributes if each.rpartition(":")[2] == local]
    return written[0] if name.startswith("{") and written else name
