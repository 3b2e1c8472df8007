"""Elements and numbers that urdfdom requires in a link. (urdf_parser/src/link.cpp)"""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.xml.parser import Element
from ..fault import Fault
from .element_attributes import AttributeCheck, fills, first

INERTIA = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
SHAPES = {"box": ("size",), "sphere": ("radius",), "cylinder": ("length", "radius"), "mesh": ("filename",)}
LATER_SHAPES = frozenset({"capsule"})
"""Shapes that newer readers support."""


class LinkCheck(AttributeCheck):
    def link(self, link: Element) -> Iterator[Fault]:
        """Yield faults at which urdfdom stops reading the link, but not the robot."""
        for fault in self.inside(link):
            message = f"{fault.message}: urdfdom prints an error and leaves out the rest of the link"
            yield Fault(fault.span, message, level="warning")

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
        """Yield what is wrong with the shape of a `<visual>` or a `<collision>`."""
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
