"""Origins and masses that xacro puts into links and joints: those in a condition, in a macro, or in the call of one."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.xml.parser import Element
from ..fault import Fault
from .element_attributes import AttributeCheck
from .link_check import INERTIA

OTHERS = frozenset({"gazebo", "plugin", "sensor", "ros2_control", "transmission", "sdf"})
"""Elements that urdfdom does not read."""
NUMBERS = {"mass": ("value",), "inertia": INERTIA}


def loose_faults(root: Element, check: AttributeCheck) -> Iterator[Fault]:
    """Yield numbers that can't be read, in elements that xacro puts into a link or a joint; others may be elsewhere."""
    for part, in_joint in loose_parts(root):
        vectors = check.vectors(part, ("xyz", "rpy")) if part.tag == "origin" else ()
        names = NUMBERS.get(part.tag, ())
        is_begun = not part.children and 2 * sum(part.get(name) is not None for name in names) >= len(names)
        numbers = check.numbers(part, names, ()) if is_begun else check.numbers(part, (), names)
        for fault in (*vectors, *numbers):
            harm = "refuses the robot" if in_joint else "leaves out what it is in"
            yield Fault(fault.span, f"{fault.message}; urdfdom {harm}", None if in_joint else "warning")


def loose_parts(root: Element) -> Iterator[tuple[Element, bool]]:
    """Yield origins and masses inside of an element of xacro, and whether a joint is around them."""
    waiting = [(root, False, False)]
    while waiting:
        around, is_loose, in_joint = waiting.pop()
        is_loose = (is_loose and around.tag not in ("link", "joint")) or around.tag.startswith("xacro:")
        for child in around.children:
            if is_loose and (child.tag == "origin" or child.tag in NUMBERS):
                yield child, in_joint
            if child.tag not in OTHERS:
                waiting.append((child, is_loose, in_joint or child.tag == "joint"))
