"""Links, joints and materials of one name: urdfdom refuses the robot."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from ...languages.xml.parser import Element
from ...source import Span
from ..fault import Fault
from .element_attributes import first, name_span

BLOCKS = frozenset({"xacro:if", "xacro:unless", "xacro:macro"})
"""Elements of xacro whose children all come out, or none."""


def is_named_only(joint: Element) -> bool:
    """Return whether a joint has nothing of one of URDF: xacro puts it into a ros2_control, a transmission or an SRDF.

    A macro, or an included file, stands for its elements wherever it is called.
    """
    return joint.get("type") is None and not any(first(joint, tag) for tag in ("parent", "child"))


def repeated(root: Element, tag: str, among: Collection[Element] | None = None) -> Iterator[Fault]:
    """Yield the children of the robot that have no name, or a repeated one; of some elements where they are given."""
    elements = [each for each in root.children if each.tag == tag and (among is None or each in among)]
    for element in elements if tag != "material" else ():
        if element.get("name") is None:
            yield Fault(element.open, f"the {tag} has no `name`: urdfdom refuses the robot")
    yield from of_one_name(elements, tag)


def repeated_in_blocks(root: Element) -> Iterator[Fault]:
    """Yield the links and joints of one block of xacro that have one name: whoever gets one of both gets the other."""
    waiting = list(root.children)
    while waiting:
        block = waiting.pop()
        if block.tag in BLOCKS:
            waiting += block.children
            yield from of_one_name([each for each in block.children if each.tag == "link"], "link")
            joints = [each for each in block.children if each.tag == "joint" and not is_named_only(each)]
            yield from of_one_name(joints, "joint")


def of_one_name(elements: Sequence[Element], tag: str) -> Iterator[Fault]:
    seen: dict[str, Span] = {}
    for element in elements:
        name = element.get("name") or "$"
        span = name_span(element)
        if "$" not in name and (before := seen.setdefault(name, span)) != span:
            message = f"two {tag}s are called `{name}`: urdfdom refuses the robot"
            yield Fault(span, message, related=((before, "the first one"),))
