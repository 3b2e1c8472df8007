"""Faults among the names of links and joints of an expanded robot; unknown parts of names compare as written."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cached_property

from ...light_dataclasses import dataclass, replace
from ...package.urdf.expansion.expansion import ExpandedAttribute, Expansion, Node
from ...package.urdf.expansion.values import XacroUnknown, shown
from ...suggest import nearest
from ..fault import Fault, Level
from .expanded_places import Found, own_place
from .lost_prefix import lost_prefix, without_prefix
from .similar_names import only_near
from .validation import VAIN, one_fault

IF = ", where the condition around it holds"


@dataclass(frozen=True)
class ExpandedTree:
    expansion: Expansion
    is_robot: bool
    """Whether it is a robot of its own; otherwise other files may have the rest of it."""

    def faults(self) -> Iterator[Found]:
        """Yield the path of each fault in a file of the package, and the fault."""
        if self.links:
            yield from self.repeated("link", self.links)
            yield from self.repeated("joint", self.joints)
            for joint in self.joints:
                yield from self.ends(joint)
            yield from self.named()

    @cached_property
    def links(self) -> list[Node]:
        return [node for node in self.expansion.children if node.tag == "link" and "name" in node.attributes]

    @cached_property
    def joints(self) -> list[Node]:
        """The joints of URDF: those of a transmission or an SRDF have neither a type nor links."""
        every = (node for node in self.expansion.children if node.tag == "joint" and "name" in node.attributes)
        return [node for node in every if "type" in node.attributes or node.first("parent") or node.first("child")]

    @cached_property
    def link_names(self) -> frozenset[str]:
        return frozenset(name_of(link) for link in self.links)

    @cached_property
    def joint_names(self) -> frozenset[str]:
        return frozenset(name_of(joint) for joint in self.joints)

    @cached_property
    def has_unknown_names(self) -> bool:
        """Whether a name has a part that is not known: it may then be any name."""
        return any(isinstance(node.attributes["name"].value, XacroUnknown) for node in (*self.links, *self.joints))

    def repeated(self, kind: str, nodes: Iterable[Node]) -> Iterator[Found]:
        seen: dict[str, Node] = {}
        for node in nodes if self.is_robot else ():
            name = name_of(node)
            if node.is_certain and name and seen.setdefault(name, node) is not node:
                place = own_place(node, node.attributes["name"].span, name, again=bool(node.calls))
                if place:
                    message = f"two {kind}s are called `{name}`: urdfdom refuses the robot"
                    yield place[0].path, Fault(place[1], message)

    def ends(self, joint: Node) -> Iterator[Found]:
        for tag in ("parent", "child"):
            end = joint.first(tag)
            link = end.attributes.get("link") if end else None
            if end is not None and link is not None:
                full = lost_prefix(link, self.link_names, self.children) if tag == "child" else ""
                if full:
                    yield from without_prefix(end, link, full, "link")
                else:
                    yield from self.unknown(end, link, self.link_names, "link", ": urdfdom refuses the robot")
        mimic = joint.first("mimic")
        if mimic is not None and "joint" in mimic.attributes:
            given = mimic.attributes["joint"]
            if full := lost_prefix(given, self.joint_names, frozenset()):
                yield from without_prefix(mimic, given, full, "joint")
            else:
                yield from self.unknown(mimic, given, self.joint_names, "joint", "")

    @cached_property
    def children(self) -> frozenset[str]:
        """The links that joints have as their child."""
        return self.links_at("child")

    @cached_property
    def asked(self) -> frozenset[str]:
        """The links that joints name, including those that the robot does not have."""
        return self.links_at("child") | self.links_at("parent")

    def links_at(self, tag: str) -> frozenset[str]:
        ends = (joint.first(tag) for joint in self.joints)
        return frozenset(shown(end.attributes["link"].value) for end in ends if end and "link" in end.attributes)

    def named(self) -> Iterator[Found]:
        """Yield the joints and links that ros2_control and Gazebo elements name, and the robot does not have."""
        yield from self.lost_joints()
        for node in self.expansion.children:
            if node.tag == "gazebo" and "reference" in node.attributes:
                if shown(node.attributes["reference"].value) in self.asked - self.link_names:
                    continue  # the finding is at the joint
                names, harm = self.link_names | self.joint_names, ": Gazebo leaves out what this says"
                yield from self.unknown(node, node.attributes["reference"], names, "link or joint", harm, "info")

    def lost_joints(self) -> Iterator[Found]:
        """Yield the joints that ros2_control moves and the robot lacks; those of one file and level are one fault."""
        lost: dict[tuple[str, Level | None], list[Fault]] = {}
        for node in self.expansion.children:
            for child in node.children if node.tag == "ros2_control" else ():
                if child.tag == "joint" and "name" in child.attributes:
                    given = child.attributes["name"]
                    for path, fault in self.unknown(child, given, self.joint_names, "joint of the robot", VAIN):
                        lost.setdefault((path, "warning"), []).append(replace(fault, level="warning"))
        for (path, _), faults in lost.items():
            yield path, one_fault(faults)

    def unknown(
        self,
        node: Node,
        given: ExpandedAttribute,
        names: frozenset[str],
        kind: str,
        harm: str,
        level: Level | None = None,
    ) -> Iterator[Found]:
        name, is_known = shown(given.value), not (isinstance(given.value, XacroUnknown) or self.has_unknown_names)
        if not name or name in names:
            return
        is_sure = self.is_robot and not self.expansion.is_open and is_known
        near = nearest(name, names) if is_sure and not level else only_near(name, names)
        place = own_place(node, given.span, name)
        if place is None or not (near or is_sure):
            return
        hint = f" (did you mean `{near}`?)" if near else ""
        milder: Level | None = level if not near else "warning"
        if not level:
            milder = None if is_sure and node.is_certain else "warning"
        when = "" if node.is_certain else IF
        yield place[0].path, Fault(place[1], f"no {kind} is called `{name}`{hint}{harm}{when}", milder)


def name_of(node: Node) -> str:
    return shown(node.attributes["name"].value)
