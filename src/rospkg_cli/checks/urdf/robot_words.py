"""Words of URDF and of ros2_control that are nearly right: their readers pass over them without a message."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from ...languages.xml.parser import Element
from ...suggest import near_names, slips
from ..fault import Fault
from .numbers import is_number

SHAPES = ("origin", "geometry", "material")
CHILDREN = {
    "link": ("visual", "collision", "inertial"),
    "joint": ("parent", "child", "origin", "axis", "limit", "dynamics", "mimic", "safety_controller", "calibration"),
    "inertial": ("origin", "mass", "inertia"),
    "visual": SHAPES,
    "collision": SHAPES,
}
"""What urdfdom reads inside of an element. (urdf_parser/src/link.cpp, joint.cpp)"""
CONTROL_TYPES = ("system", "actuator", "sensor")
"""What the resource manager of ros2_control loads. (hardware_interface/src/resource_manager.cpp)"""
INTERFACES = ("position", "velocity", "effort", "acceleration")
"""The interfaces of joints that have a name in ros2_control. (hardware_interface_type_values.hpp)"""


def misspelt_parts(part: Element) -> Iterator[Fault]:
    """Yield what is nearly an element of a link or a joint."""
    for element in (part, *(each for each in part.children if each.tag in CHILDREN)):
        yield from children_of(element)


def control_faults(root: Element) -> Iterator[Fault]:
    """Yield what is nearly a word of a `<ros2_control>`, of a robot or of a macro."""
    for control in (each for each in root.walk() if each.tag == "ros2_control"):
        yield from kind_of(control)
        yield from interfaces_of(control)


def children_of(element: Element) -> Iterator[Fault]:
    known = CHILDREN[element.tag]
    for child in element.children:
        near = near_names(child.tag, known) if child.tag not in known and ":" not in child.tag else []
        if near:
            start = f"`<{child.tag}>` is no part of a `<{element.tag}>` (did you mean `<{near[0]}>`?)"
            if near[0] == "origin" and is_zero(child):
                yield Fault(
                    child.open, f"{start}: it is passed over, and says what holds without it; correct it", "info"
                )
            else:
                yield Fault(child.open, f"{start}: it is passed over; correct it", "warning")


def is_zero(origin: Element) -> bool:
    """Return whether an origin is the one that holds where none is given."""
    numbers = " ".join(origin.get(each) or "0" for each in ("xyz", "rpy")).split()
    return all(is_number(each) and float(each) == 0 for each in numbers)


def kind_of(control: Element) -> Iterator[Fault]:
    kind = control.attributes.get("type")
    near = near_names(kind.value, CONTROL_TYPES) if kind is not None and kind.value not in CONTROL_TYPES else []
    if kind is not None and near and kind.value.lower() not in CONTROL_TYPES:
        what = f"`{kind.value}` is no type of a `<ros2_control>` (did you mean `{near[0]}`?)"
        yield Fault(kind.value_span, f"{what}: controller_manager loads no hardware for it; correct it")


def interfaces_of(control: Element) -> Iterator[Fault]:
    named = [
        name
        for joint in (each for each in control.walk() if each.tag == "joint")
        for each in joint.children
        if each.tag in ("command_interface", "state_interface") and (name := each.attributes.get("name")) is not None
    ]
    values = Counter(name.value for name in named)
    for name in named:
        if name.value in INTERFACES:
            continue
        others = [each for each in INTERFACES if each in values and values[name.value] == 1]
        near = slips(name.value, INTERFACES) or near_names(name.value, others, 1)
        if near:
            what = f"`{name.value}` is no common interface of a joint (did you mean `{near[0]}`?)"
            yield Fault(
                name.value_span, f"{what}: a controller that asks for that does not start; correct it", "warning"
            )
