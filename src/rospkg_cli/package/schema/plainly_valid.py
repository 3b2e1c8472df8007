"""Whether a package.xml plainly fits its schema, so that libxml2 need not be imported: that takes a tenth of a start.

Children in order with plain text and few attributes, as in most packages; of everything else nothing is said.
"""

from __future__ import annotations

from ...languages.xml.elements import Document, Element
from ...lazy_regex import regex
from ...ros.manifest import DEPENDENCY_TAGS, EMAIL, NEW_IN, ONCE, PACKAGE_NAME, REQUIRED, URL_TYPES, VERSION, place_of

WORDS = regex(r"\w[\w .,:;/@()+-]*")
PLAIN_URL = regex(r"https?://[A-Za-z0-9-]+(\.[A-Za-z0-9-]+)+(/[A-Za-z0-9._-]+)*/?")
URL_VALUES = [{"type": each} for each in URL_TYPES]
DEPENDENCIES = frozenset(DEPENDENCY_TAGS) - {"run_depend"}
LONGEST = 100_000
"""Characters; libxml2 has limits that expat has not."""


def is_plainly_valid(document: Document, format: int) -> bool:
    """Return whether a document certainly fits the schema of its format; False where that needs the schema."""
    root, text = document.root, document.source.text
    if format not in (2, 3) or not text.isascii() or len(text) > LONGEST:
        return False
    if root.tag != "package" or values_of(root) != {"format": str(format)}:
        return False
    children = root.children
    tags = [child.tag for child in children]
    places = [place_of(tag) for tag in tags]
    return (
        is_blank(root)
        and places == sorted(places)
        and all(tag in tags for tag in REQUIRED)
        and all(tags.count(tag) < 2 for tag in ONCE)
        and all(is_plain(child, format) for child in children)
    )


def is_plain(child: Element, format: int) -> bool:
    """Return whether a child certainly fits the type that the schema gives its tag."""
    tag, values = child.tag, values_of(child)
    if tag == "export":
        return not values and is_blank(child) and not any(each.children or ":" in each.tag for each in child.children)
    if child.nodes:
        return False
    text = "".join(child.chunks)
    if tag in ("maintainer", "author"):
        return bool([*values] == ["email"] and EMAIL.fullmatch(values["email"]) and WORDS.fullmatch(text))
    if tag == "url":
        return bool(({"type": "website"} | values) in URL_VALUES and PLAIN_URL.fullmatch(text))
    if values:
        return False
    if tag == "description":
        return not child.nodes
    if tag == "name" or (tag in NEW_IN[3] and format == 3):
        return bool(PACKAGE_NAME.fullmatch(text))
    if tag == "version":
        return bool(VERSION.fullmatch(text))
    return bool((tag == "license" or tag in DEPENDENCIES) and WORDS.fullmatch(text))


def values_of(element: Element) -> dict[str, str]:
    return {name: each.value for name, each in element.attributes.items()}


def is_blank(element: Element) -> bool:
    return not "".join(element.chunks).strip(" \t\r\n")
