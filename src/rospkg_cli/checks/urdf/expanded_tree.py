"""Links and joints of a robot as xacro leaves them, with names whose unknown parts are compared as they are written."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cached_property

from ...light_dataclasses import dataclass, replace
from ...package.urdf.expansion.expansion import ExpandedAttribute, Expansion, Node
from ...package.urdf.expansion.values import XacroUnknown, shown
from ...suggest import near_names, nearest
from ..fault import Fault, Level
from .expanded_places import Found, own_place
from .lost_prefix import lost_prefix, without_prefix
from .validation import VAIN, one_fault

WORD = re.compile(r"[_\W]+")
LONG = 6
"""Letters of a word of which two may be wrong."""
IF = ", where the condition around it holds"


@dataclass(frozen=True)
class ExpandedTree:
    expansion: Expansion
    is_robot: bool
    """Whether it is a robot of its own: else other files may have the rest of it."""

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
        """Whether a part of a name is given from outside: then it may be any name."""
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
                meant = lost_prefix(link, self.link_names, self.children) if tag == "child" else ""
                if meant:
                    yield from without_prefix(end, link, meant, "link")
                else:
                    yield from self.unknown(end, link, self.link_names, "link", ": urdfdom refuses the robot")
        mimic = joint.first("mimic")
        if mimic is not None and "joint" in mimic.attributes:
            given = mimic.attributes["joint"]
            if meant := lost_prefix(given, self.joint_names, frozenset()):
                yield from without_prefix(mimic, given, meant, "joint")
            else:
                yield from self.unknown(mimic, given, self.joint_names, "joint", "")

    @cached_property
    def children(self) -> frozenset[str]:
        """The links that joints have as their child."""
        return self.links_at("child")

    @cached_property
    def asked(self) -> frozenset[str]:
        """The links that joints join, those that are not there too."""
        return self.links_at("child") | self.links_at("parent")

    def links_at(self, tag: str) -> frozenset[str]:
        ends = (joint.first(tag) for joint in self.joints)
        return frozenset(shown(end.attributes["link"].value) for end in ends if end and "link" in end.attributes)

    def named(self) -> Iterator[Found]:
        """Yield what is said of joints and links that the robot does not have: to ros2_control, and to Gazebo."""
        yield from self.lost_joints()
        for node in self.expansion.children:
            if node.tag == "gazebo" and "reference" in node.attributes:
                if shown(node.attributes["reference"].value) in self.asked - self.link_names:
                    continue  # the joint tells it
                names, harm = self.link_names | self.joint_names, ": Gazebo leaves out what this says"
                yield from self.unknown(node, node.attributes["reference"], names, "link or joint", harm, "info")

    def lost_joints(self) -> Iterator[Found]:
        """Yield the joints that ros2_control moves and the robot lacks, those of one file and level as one."""
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


def only_near(name: str, names: Iterable[str]) -> str | None:
    """Return the one name that a letter makes of another, or two of long words; none that is a sibling of it."""
    close = near_names(name, names, 1)
    found = close or near_names(name, names)
    if len(found) != 1 or "@" in name or are_siblings(name, found[0]):
        return None
    words = [word for word in WORD.split(name) if word not in WORD.split(found[0])]
    return found[0] if close or all(len(word) >= LONG for word in words) else None


def name_of(node: Node) -> str:
    return shown(node.attributes["name"].value)


def are_siblings(a: str, b: str) -> bool:
    """Return whether two names differ by a number or a letter that stands alone, as `wheel_l` and `wheel_r` do."""
    words = WORD.split(a), WORD.split(b)
    if len(words[0]) != len(words[1]):
        return False
    different = [pair for pair in zip(*words, strict=True) if pair[0] != pair[1]]
    return all((is_mark(one) and is_mark(other)) or numberless(one) == numberless(other) for one, other in different)


def is_mark(word: str) -> bool:
    return len(word) <= 2


def numberless(word: str) -> str:
    return re.sub(r"\d+", "0", word)
