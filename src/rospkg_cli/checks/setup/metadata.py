"""Rule input: metadata that setup.py and package.xml both have."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ...languages.xml.parser import Element
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.manifest import Manifest
from ...package.setup.setup_py import SetupPy
from ...package.setup.setup_text import SetupText
from ...ros.licenses import spdx_id
from ..manifest.placeholders import is_placeholder

SEVERAL = regex(r"\s*(?:,|;|\band\b|&|\|)\s*")
ADDRESS = regex(r"\s*<[^>]*>")
TODO = regex(r"todo\b.*", re.IGNORECASE | re.DOTALL)

REAL = regex(r"[^\s@]+@[^\s@]+\.[^\s@]+")
"""An address that is one."""

MAX_LENGTH = 1_000
"""In characters: a longer license or list of names is none, and parting it is slow."""

Difference = tuple[str, SetupText, str, Element]
"""The argument of setup(), its text, the text of package.xml ("" where that is not one), and the element with it."""


@dataclass(frozen=True)
class Metadata:
    manifest: Manifest
    setup: SetupPy

    @cached_property
    def differing(self) -> tuple[Difference, ...]:
        return (*self.description(), *self.license(), *(tuple(self.maintainer()) or self.email()))

    def description(self) -> Iterator[Difference]:
        """Two descriptions may well be worded differently; one that a template left may not."""
        argument, element = self.setup.setup_text("description"), self.manifest.first("description")
        if argument is None or element is None or element.children or not element.text or TODO.fullmatch(element.text):
            return
        if TODO.fullmatch(argument.text.strip()) or not argument.text.strip():
            yield "description", argument, " ".join(element.text.split()), element

    def license(self) -> Iterator[Difference]:
        argument, elements = self.setup.setup_text("license"), self.manifest.all("license")
        texts = [element.text for element in elements]
        if any(TODO.fullmatch(text) or not text for text in texts):
            return
        if argument is None or is_long(argument) or not texts:
            return
        known = {spdx(text) for text in texts}
        if spdx(argument.text) not in known and not {spdx(part) for part in SEVERAL.split(argument.text)} <= known:
            is_known = spdx_id(argument.text) is not None  # which of two licenses holds is for its owner to say
            yield "license", argument, texts[0] if len(texts) == 1 and not is_known else "", elements[0]

    def maintainer(self) -> Iterator[Difference]:
        argument, elements = self.setup.setup_text("maintainer"), self.manifest.all("maintainer")
        if argument is None or is_long(argument) or not elements or any(is_placeholder(e.text) for e in elements):
            return
        ours = {folded(ADDRESS.sub("", part)) for part in SEVERAL.split(argument.text)}
        theirs = {folded(element.text) for element in elements}
        if ours.isdisjoint(theirs) and folded(argument.text) not in theirs:
            yield "maintainer", argument, elements[0].text if len(elements) == 1 else "", elements[0]

    def email(self) -> Iterator[Difference]:
        argument, elements = self.setup.setup_text("maintainer_email"), self.manifest.all("maintainer")
        addresses = [address.value for e in elements if (address := e.attributes.get("email"))]
        if argument is None or is_long(argument) or not addresses or not all(map(REAL.fullmatch, addresses)):
            return
        if any(map(is_placeholder, addresses)):
            return  # XML104 reports it
        ours = {folded(part) for part in SEVERAL.split(argument.text)}
        if ours.isdisjoint(folded(address) for address in addresses):
            yield "maintainer_email", argument, addresses[0] if len(addresses) == 1 else "", elements[0]


def is_long(argument: SetupText) -> bool:
    return len(argument.text) > MAX_LENGTH


def folded(text: str) -> str:
    """Return a text by its words alone."""
    return " ".join(text.casefold().split()).strip(" .")


def spdx(text: str) -> str:
    return (spdx_id(text) or text).casefold()
