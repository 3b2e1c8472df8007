"""Elements and numbers that urdfdom requires in a joint. (urdf_parser/src/joint.cpp)"""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.xml.parser import Element
from ..fault import Fault
from .element_attributes import AttributeCheck, fills, first, name_span

JOINT_TYPES = ("revolute", "continuous", "prismatic", "fixed", "floating", "planar")
WITHOUT_AXIS = ("floating", "fixed")
JOINT_NUMBERS = {
    "limit": (("effort", "velocity"), ("lower", "upper")),
    "safety_controller": (("k_velocity",), ("soft_lower_limit", "soft_upper_limit", "k_position")),
    "calibration": ((), ("rising", "falling")),
    "mimic": ((), ("multiplier", "offset")),
    "dynamics": ((), ("damping", "friction")),
}
"""For each child of a joint: the numbers that it must have, and those that it may have."""


class JointCheck(AttributeCheck):
    def joint(self, joint: Element) -> Iterator[Fault]:
        """Yield faults at which urdfdom refuses the whole robot."""
        for fault in self.motion(joint):
            yield Fault(fault.span, f"{fault.message}; urdfdom refuses the robot")

    def ends(self, joint: Element) -> Iterator[Fault]:
        """Yield the missing end of a joint that has only one, for a robot whose links and joints are not all known."""
        given = {tag: end for tag in ("parent", "child") if (end := first(joint, tag)) is not None}
        for tag in ("parent", "child") if given else ():
            if not (fills(joint) or (tag in given and (given[tag].get("link") or fills(given[tag])))):
                yield Fault(name_span(joint), f"the joint has no `<{tag} link=…>`: urdfdom refuses the robot")

    def to_itself(self, joint: Element) -> Iterator[Fault]:
        """Yield a joint whose two ends are the same link; urdfdom accepts it if another link is the root."""
        given = [end for tag in ("parent", "child") if (end := first(joint, tag)) is not None]
        ends = [end.attributes["link"] for end in given if "link" in end.attributes]
        if len(ends) == 2 and ends[0].value == ends[1].value != "":
            message = f"the joint joins `{ends[1].value}` to itself: it hangs on no other link, and its frame is lost"
            yield Fault(ends[1].value_span, message, level="warning")

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
