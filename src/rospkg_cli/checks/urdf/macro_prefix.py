"""Names in a macro of xacro that lack the prefix which all joints of the macro have."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.xml.parser import Element
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
        names = {joint.get("name") for joint in joints}
        for joint in joints if prefix else ():
            for mimic in joint.children:
                given = mimic.attributes.get("joint") if mimic.tag == "mimic" else None
                if given is not None and prefix + given.value in names:
                    message = (
                        f"`{given.value}` lacks the prefix of `{prefix}{given.value}`: where a call of the macro "
                        f"`{macro.get('name')}` gives one, no joint has this name; write the prefix"
                    )
                    yield Fault(given.value_span, message, "info")


def prefix_of(names: list[str]) -> str:
    """Return the `${…}` that all names begin with; "" where they have none in common, or are too few."""
    matches = [PREFIXED.fullmatch(name) for name in names]
    found = {match.group(1) if match else "" for match in matches}
    return found.pop() if len(found) == 1 and len(names) >= FEWEST else ""
