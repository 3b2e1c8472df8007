"""Names in a macro of xacro that lack the prefix which all joints of the macro have."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.xml.parser import Attribute, Element
from ...lazy_regex import regex
from ..fault import Fault

PREFIXED = regex(r"(\$\{(\w+)\})(.+)")
FEWEST = 2
"""Joints of a macro that show what its names begin with."""


def prefix_faults(root: Element) -> Iterator[Fault]:
    """Yield the joints that a `<mimic>` in a macro names without the prefix; a call without a prefix finds them."""
    for macro in root.walk():
        if macro.tag != "xacro:macro":
            continue
        joints = [each for each in macro.walk() if each.tag == "joint" and each.attributes.get("type")]
        prefix = prefix_of([joint.get("name") or "" for joint in joints])
        names = {joint.get("name") or "" for joint in joints}
        for mimic in (each for joint in joints if prefix for each in joint.children if each.tag == "mimic"):
            given = mimic.attributes.get("joint")
            if given is not None and prefix + given.value in names:
                message = (
                    f"`{given.value}` lacks the prefix of `{prefix}{given.value}`: where a call of the macro "
                    f"`{macro.get('name')}` gives one, no joint has this name; write the prefix"
                )
                yield Fault(given.value_span, message, "info")
            elif given is not None and given.value.startswith(prefix) and not is_given_elsewhere(root, given.value):
                yield from longer_name(given, names)


def is_given_elsewhere(root: Element, name: str) -> bool:
    """Return whether anything but a `<mimic>` has a name: a joint, or a macro that makes one of it."""
    others = (element for element in root.walk() if element.tag != "mimic")
    return any(attribute.value == name for element in others for attribute in element.attributes.values())


def longer_name(given: Attribute, names: set[str]) -> Iterator[Fault]:
    """Yield a mimicked joint that no joint of its macro is, where names of joints begin with it."""
    longer = sorted(name for name in names if name.startswith(f"{given.value}_"))
    if longer:
        message = (
            f"no joint of this macro is called `{given.value}`: it must be made elsewhere, or `{longer[0]}` is meant"
        )
        yield Fault(given.value_span, message, "info")


def prefix_of(names: list[str]) -> str:
    """Return the `${…}` that all names begin with; "" where they have none in common, or are too few."""
    matches = [PREFIXED.fullmatch(name) for name in names]
    found = {match.group(1) if match else "" for match in matches}
    return found.pop() if len(found) == 1 and len(names) >= FEWEST else ""
