"""Elements, attributes and numbers that urdfdom requires in links and joints. (urdf_parser/src/link.cpp, joint.cpp)"""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.xml.parser import Attribute, Element
from ...lazy_regex import regex
from ...source import Source, Span
from ..fault import Fault
from .numbers import is_number, vector_fault

JOINT_TYPES = ("revolute", "continuous", "prismatic", "fixed", "floating", "planar")
WITHOUT_AXIS = ("floating", "fixed")
INERTIA = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
SHAPES = {"box": ("size",), "sphere": ("radius",), "cylinder": ("length", "radius"), "mesh": ("filename",)}
LATER_SHAPES = frozenset({"capsule"})
"""Shapes that newer readers know."""

JOINT_NUMBERS = {
    "limit": (("effort", "velocity"), ("lower", "upper")),
    "safety_controller": (("k_velocity",), ("soft_lower_limit", "soft_upper_limit", "k_position")),
    "calibration": ((), ("rising", "falling")),
    "mimic": ((), ("multiplier", "offset")),
    "dynamics": ((), ("damping", "friction")),
}
"""For each child of a joint: the numbers that it must have, and those that it may have."""

SPACE = regex(r"[\t\r\n]")
VECTORS = {"xyz": 3, "rpy": 3, "size": 3, "scale": 3}


class ElementCheck:
    """Checks single elements; what xacro fills in is taken to be right."""

    def __init__(self, source: Source, *, is_xacro: bool = False) -> None:
        self.source = source
        self.is_xacro = is_xacro

    def link(self, link: Element) -> Iterator[Fault]:
        """Yield faults at which urdfdom stops reading the link, but not the robot."""
        for fault in self.inside(link):
            message = f"{fault.message}: urdfdom prints an error and leaves out the rest of the link"
            yield Fault(fault.span, message, level="warning")

    def joint(self, joint: Element) -> Iterator[Fault]:
        for fault in self.motion(joint):
            yield Fault(fault.span, f"{fault.message}; urdfdom refuses the robot")

    def ends(self, joint: Element) -> Iterator[Fault]:
        """Yield the end that a joint with one lacks, where no tree is made of its robot."""
        given = {tag: end for tag in ("parent", "child") if (end := first(joint, tag)) is not None}
        for tag in ("parent", "child") if given else ():
            if not (fills(joint) or (tag in given and (given[tag].get("link") or fills(given[tag])))):
                yield Fault(name_span(joint), f"the joint has no `<{tag} link=…>`: urdfdom refuses the robot")

    def to_itself(self, joint: Element) -> Iterator[Fault]:
        """Yield that the two ends of a joint are one link; urdfdom takes it, where another link is the root."""
        given = [end for tag in ("parent", "child") if (end := first(joint, tag)) is not None]
        ends = [end.attributes["link"] for end in given if "link" in end.attributes]
        if len(ends) == 2 and ends[0].value == ends[1].value != "":
            message = f"the joint joins `{ends[1].value}` to itself: it hangs on no other link, and its frame is lost"
            yield Fault(ends[1].value_span, message, level="warning")

    def inside(self, link: Element) -> Iterator[Fault]:
        if inertial := first(link, "inertial"):
            yield from self.inertial(inertial)
        for element in link.children:
            if element.tag in ("visual", "collision"):
                yield from self.visual(element)

    def inertial(self, inertial: Element) -> Iterator[Fault]:
        yield from self.origin(inertial)
        for tag, names in (("mass", ("value",)), ("inertia", INERTIA)):
            element = first(inertial, tag)
            if element is None and not fills(inertial):
                yield Fault(inertial.open, f"`<inertial>` has no `<{tag}>`")
            elif element is not None:
                yield from self.numbers(element, names, ())

    def visual(self, element: Element) -> Iterator[Fault]:
        yield from self.origin(element)
        geometry = first(element, "geometry")
        material = first(element, "material")
        if geometry is not None:
            yield from self.geometry(geometry)
        elif not fills(element):
            yield Fault(element.open, f"`<{element.tag}>` has no `<geometry>`")
        if element.tag == "visual" and material is not None and material.get("name") is None and not fills(material):
            yield Fault(material.open, "`<material>` in a `<visual>` needs a `name`")

    def geometry(self, geometry: Element) -> Iterator[Fault]:
        shape = next(iter(geometry.children), None)
        if shape is None:
            yield Fault(geometry.open, "`<geometry>` is empty: a box, sphere, cylinder or mesh belongs into it")
        elif shape.tag in SHAPES:
            vector = shape.tag in ("box", "mesh")
            names = SHAPES[shape.tag] if shape.tag != "mesh" else ()
            yield from self.vectors(shape, ("size", "scale")) if vector else self.numbers(shape, names, ())
            for name in SHAPES[shape.tag] if vector else ():
                if name not in shape.attributes and not fills(shape):
                    yield Fault(shape.open, f"`<{shape.tag}>` has no `{name}`")
        elif ":" not in shape.tag and shape.tag not in LATER_SHAPES:
            yield Fault(shape.open, f"`<{shape.tag}>` is no shape: box, sphere, cylinder or mesh")

    def motion(self, joint: Element) -> Iterator[Fault]:
        yield from self.origin(joint)
        kind = joint.attributes.get("type")
        if kind is None:
            if not fills(joint):
                yield Fault(joint.open, "the joint has no `type`: " + ", ".join(f"`{each}`" for each in JOINT_TYPES))
        elif kind.value not in JOINT_TYPES and "$" not in kind.value:
            yield Fault(kind.value_span, f"`{kind.value}` is no type of a joint: " + ", ".join(JOINT_TYPES))
        elif kind.value in ("revolute", "prismatic") and first(joint, "limit") is None and not fills(joint):
            message = f"a {kind.value} joint needs a `<limit>` with `effort` and `velocity`"
            yield Fault(kind.value_span, message + (" (or is it `continuous`?)" if kind.value == "revolute" else ""))
        axis = first(joint, "axis")
        if axis is not None and kind is not None and kind.value not in WITHOUT_AXIS:
            yield from self.vectors(axis, ("xyz",))
        yield from self.parts(joint)

    def parts(self, joint: Element) -> Iterator[Fault]:
        for tag, (needed, possible) in JOINT_NUMBERS.items():
            element = first(joint, tag)
            if element is not None:
                yield from self.numbers(element, needed, possible)
        mimic, dynamics = first(joint, "mimic"), first(joint, "dynamics")
        if mimic is not None and mimic.get("joint") is None and not fills(mimic):
            yield Fault(mimic.open, "`<mimic>` has no `joint`")
        if dynamics is not None and not {"damping", "friction"} & set(dynamics.attributes) and not fills(dynamics):
            yield Fault(dynamics.open, "`<dynamics>` has neither `damping` nor `friction`")

    def origin(self, element: Element) -> Iterator[Fault]:
        if (origin := first(element, "origin")) is not None:
            yield from self.vectors(origin, ("xyz", "rpy"))

    def vectors(self, element: Element, names: tuple[str, ...]) -> Iterator[Fault]:
        for name in names:
            found = element.attributes.get(name)
            if found is not None and (text := self.raw(found)) is not None:
                fault = vector_fault(text, VECTORS[name])
                if fault:
                    yield Fault(found.value_span, f"`{name}` of `<{element.tag}>` can't be read: {fault}")

    def numbers(self, element: Element, needed: tuple[str, ...], possible: tuple[str, ...]) -> Iterator[Fault]:
        missing = [f"`{name}`" for name in needed if name not in element.attributes]
        if missing and not fills(element):
            yield Fault(element.open, f"`<{element.tag}>` has no {', '.join(missing)}")
        for name in (*needed, *possible):
            found = element.attributes.get(name)
            if found is None:
                continue
            if (text := self.raw(found)) is not None and not is_number(text):
                yield Fault(found.value_span, f"`{name}` of `<{element.tag}>` is no number: `{text}`")

    def raw(self, attribute: Attribute) -> str | None:
        """Return a value as urdfdom gets it; None where xacro fills it in.

        urdfdom does not turn tabs and line ends into blanks, and the parser of xacro does.
        """
        text = self.source.slice(attribute.value_span)
        text = SPACE.sub(" ", text) if self.is_xacro else text
        return None if "$" in text else text


def first(element: Element, tag: str) -> Element | None:
    return next((child for child in element.children if child.tag == tag), None)


def fills(element: Element) -> bool:
    """Return whether xacro may put something into an element."""
    makes = any(":" in child.tag and child.tag != "xacro:property" for child in element.children)
    return makes or any("xacro:" in name for name in element.attributes)


def name_span(element: Element) -> Span:
    found = element.attributes.get("name")
    return found.value_span if found else element.open
