"""Names in a macro or a robot of xacro that lack the prefix which all joints of it have."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...languages.xml.parser import Attribute, Element
from ...lazy_regex import regex
from ..fault import Fault

PREFIXED = regex(r"(\$\{(\w+)\})(.+)")
FEWEST = 2
"""Joints of a macro, or of a robot, that show what its names begin with."""
MACRO = "xacro:macro"


def prefix_faults(root: Element) -> Iterator[Fault]:
    """Yield the names in a macro or robot that lack the prefix: of mimicked joints, and of links."""
    macros = [each for each in root.walk() if each.tag == MACRO]
    for macro in (root, *macros):
        inside = within(macro)
        joints = [each for each in inside if each.tag == "joint" and each.attributes.get("type")]
        prefix = prefix_of([joint.get("name") or "" for joint in joints])
        names = {joint.get("name") or "" for joint in joints}
        for mimic in (each for joint in joints if prefix for each in joint.children if each.tag == "mimic"):
            given = mimic.attributes.get("joint")
            if given is not None and prefix + given.value in names:
                yield lacking(macro, given, prefix, "joint")
            elif given is not None and given.value.startswith(prefix) and not is_given_elsewhere(root, given.value):
                yield from longer_name(given, names)
        links = {each.get("name") or "" for each in inside if each.tag == "link"}
        yield from children(macro, joints, links, prefix) if prefix else ()


def within(part: Element) -> list[Element]:
    """Return the elements of a macro, or those of a robot that are in none of its macros."""
    found: list[Element] = []
    waiting = list(part.children)
    while waiting:
        each = waiting.pop()
        if each.tag != MACRO:
            found.append(each)
            waiting += each.children
    return found


def lacking(macro: Element, given: Attribute, prefix: str, kind: str) -> Fault:
    where = f"where a call of the macro `{macro.get('name')}` gives one" if macro.tag == MACRO else "where one is given"
    lost = f"`{given.value}` lacks the prefix of `{prefix}{given.value}`"
    message = f"{lost}: {where}, no {kind} has this name; write the prefix"
    return Fault(given.value_span, message, "info")


def children(macro: Element, joints: Sequence[Element], links: set[str], prefix: str) -> Iterator[Fault]:
    """Yield the child links without the prefix, where the link that has it is no joint's child."""
    ends = [end for joint in joints for end in joint.children if end.tag == "child"]
    given = [end.attributes["link"] for end in ends if "link" in end.attributes]
    taken = {each.value for each in given}
    for each in given:
        if prefix + each.value in links - taken and each.value not in links:
            yield lacking(macro, each, prefix, "link")


def is_given_elsewhere(root: Element, name: str) -> bool:
    """Return whether anything but a `<mimic>` has a name: a joint, or a macro that makes one of it."""
    others = (element for element in root.walk() if element.tag != "mimic")
    return any(attribute.value == name for element in others for attribute in element.attributes.values())


def longer_name(given: Attribute, names: set[str]) -> Iterator[Fault]:
    """Yield a mimicked joint that no joint of its macro is, where names of joints begin with it."""
    longer = sorted(name for name in names if name.startswith(f"{given.value}_"))
    if longer:
        message = f"no joint of this macro is called `{given.value}`: define it elsewhere, or write `{longer[0]}`"
        yield Fault(given.value_span, message, "info")


def prefix_of(names: list[str]) -> str:
    """Return the `${…}` that all names begin with; "" where they have none in common, or are too few."""
    matches = [PREFIXED.fullmatch(name) for name in names]
    found = {match.group(1) if match else "" for match in matches}
    return found.pop() if len(found) == 1 and len(names) >= FEWEST else ""
