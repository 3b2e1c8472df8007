"""What is wrong with a tag of package.xml that its format does not allow where it is (XML001)."""

from __future__ import annotations

from ...languages.xml.elements import Element
from ...package.manifest import Manifest
from ...package.schema.violation import Violation, ViolationKind
from ...ros.manifest import INSIDE_EXPORT, NEW_IN, ORDER
from ...suggest import did_you_mean, nearest

TAGS = [each for place in ORDER for each in (place if isinstance(place, tuple) else (place,))]
RENAMED = {"run_depend": "exec_depend"}
"""What format 2 calls otherwise."""


def intended_tag(manifest: Manifest, element: Element) -> str | None:
    """Return the tag of package.xml that an unknown one probably is; None for a known one in a wrong place."""
    if element not in manifest.root.children or element.tag in (*INSIDE_EXPORT, *NEW_IN[2]):
        return None
    return RENAMED.get(element.tag) or nearest(element.tag, TAGS)


def misplaced_tag(manifest: Manifest, tag: str, top: bool) -> str:
    """Return what is wrong with a tag that is not allowed where it is, and what to write instead."""
    format = manifest.schema_format
    if not top:
        return f"`<{tag}>` is where only text is allowed; remove it"
    if tag in INSIDE_EXPORT:
        return f"`<{tag}>` belongs inside `<export>`; move it there"
    if tag == "run_depend":
        return f"`<run_depend>` was removed in format 2, and this is format {format}; write `<exec_depend>`"
    if tag in NEW_IN[2]:
        return f'`<{tag}>` came with format 2, and this is format {format}; write `<package format="3">`'
    return f"`<{tag}>` is no tag of package.xml{did_you_mean(tag, TAGS)}; tools' own tags belong inside `<export>`"


def is_of_format_2(manifest: Manifest, violation: Violation) -> bool:
    """Return whether it is a tag of format 2 in one of format 1: all of them have one cause."""
    is_top = violation.kind is ViolationKind.CHILD and violation.element in manifest.root.children
    return is_top and manifest.schema_format == 1 and violation.element.tag in NEW_IN[2]


def is_group(violation: Violation) -> bool:
    """Return whether it is the name of a group, which only REP-149's text forbids, and no tool."""
    return violation.kind is ViolationKind.VALUE and violation.element.tag in NEW_IN[3]
