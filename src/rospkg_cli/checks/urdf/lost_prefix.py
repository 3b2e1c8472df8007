"""Names of an expanded robot that lack the prefix which the names of their macro have."""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex
from ...package.urdf.expansion.expansion import ExpandedAttribute, Node
from ...package.urdf.expansion.values import XacroUnknown, shown
from ..fault import Fault
from .expanded_places import Found, own_place

PREFIX = regex(r"\$\{[^{}]+\}")
"""What is not known of a name, as it is written."""
UNLESS = ", unless the prefix of "
UNLESS_EMPTY, EMPTY = " is empty: ", " is empty, as it is in each call here: "
"""Parts of the message on a prefix that may be empty, and on one that is."""


def lost_prefix(given: ExpandedAttribute, names: frozenset[str], taken: frozenset[str]) -> str:
    """Return the one name that a literal one is without the `${…}` before it; "" for none, or for one in use."""
    name = shown(given.value)
    if not name or name in names or isinstance(given.value, XacroUnknown):
        return ""
    found = [each for each in names if PREFIX.fullmatch(each.removesuffix(name)) and each.endswith(name)]
    return found[0] if len(found) == 1 and found[0] not in taken else ""


def without_prefix(node: Node, given: ExpandedAttribute, full: str, kind: str) -> Iterator[Found]:
    """Yield a name without the prefix that all names of its macro have."""
    name = shown(given.value)
    place = own_place(node, given.span, name)
    if place is not None:
        message = f"no {kind} is called `{name}`{UNLESS}`{full}`{UNLESS_EMPTY}write `{full}`"
        yield place[0].path, Fault(place[1], message, "warning")
