"""Violations of the schema of package.xml."""

from __future__ import annotations

from enum import Enum

from ...languages.xml.elements import Element
from ...light_dataclasses import dataclass


class ViolationKind(Enum):
    """What a schema can forbid, with the words for it."""

    CHILD = "an element that may not stand here"
    MISSING = "a required element is not there"
    REPEATED = "an element that may stand once stands again"
    ATTRIBUTE = "an attribute that may not stand here"
    MISSING_ATTRIBUTE = "a required attribute is not there"
    VALUE = "a value of the wrong shape"
    TEXT = "text where only elements may stand"


@dataclass(frozen=True)
class Violation:
    """One thing that the schema forbids."""

    kind: ViolationKind
    element: Element
    """The offender; for MISSING the parent, for TEXT the element that holds the text."""
    name: str
    """Of the tag or the attribute in question; "" where the value is the element's own text."""
