"""Links joined by joints: urdfdom wants one tree with one root. (urdf_parser/src/model.cpp)"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...languages.xml.parser import Element
from ...source import Span
from ...suggest import did_you_mean
from ..fault import Fault
from .element_attributes import first, name_span


class KinematicTree:
    """The links and joints of one robot, all of them, with literal names."""

    def __init__(self, robot: Element, links: Sequence[Element], joints: Sequence[Element]) -> None:
        self.robot, self.links, self.joints = robot, links, joints
        self.names = {link.get("name") or "": link for link in reversed(links)}
        self.parent: dict[str, str] = {}
        self.seen: set[str] = set()
        """The names of the joints so far."""
        self.broken = False

    def faults(self, *, piece: bool) -> Iterator[Fault]:
        """Yield what is wrong; of a file that may be part of a robot, only what no other file can repair.

        The links that its joints name may be in other files: what xacro makes of the whole robot shows them.
        """
        for joint in self.joints:
            for fault in self.ends(joint, piece):
                self.broken = True
                yield fault
        if not self.broken and not piece:
            yield from self.roots()

    def ends(self, joint: Element, piece: bool) -> Iterator[Fault]:
        ends = {}
        for tag in ("parent", "child"):
            element = first(joint, tag)
            link = element.attributes.get("link") if element else None
            if link is None or not link.value:
                yield Fault(name_span(joint), f"the joint has no `<{tag} link=…>`: urdfdom refuses the robot")
            elif link.value not in self.names:
                if not piece:
                    hint = did_you_mean(link.value, self.names)
                    yield Fault(link.value_span, f"no link is called `{link.value}`{hint}: urdfdom refuses the robot")
            else:
                ends[tag] = link
        if len(ends) == 2:
            child, name = ends["child"].value, joint.get("name") or ""
            if child == ends["parent"].value:  # the joint has its own finding
                self.broken = True
                return
            if child in self.parent and not (name and name in self.seen):  # else both joints have one name
                message = f"`{child}` is the child of two joints: a robot is a tree, and its readers take one of them"
                yield Fault(ends["child"].value_span, message, "warning")
            self.parent[child] = ends["parent"].value
            self.seen.add(name)

    def roots(self) -> Iterator[Fault]:
        roots = [name for name in self.names if name not in self.parent]
        sizes = {root: len(list(self.reached(root))) for root in roots}
        if not roots:
            yield Fault(self.robot.open, "no link is a root: each one is the child of a joint, in a circle")
            return
        main = max(roots, key=lambda root: sizes[root])
        for root in sorted(roots, key=lambda root: self.span(root)):
            if root != main:
                message = f"no joint joins `{root}` to `{main}`: a robot has one root, and urdfdom refuses two"
                yield Fault(self.span(root), message, related=((self.span(main), "the root of most of the links"),))
        inside = {name for root in roots for name in self.reached(root)}
        circle = [name for name in self.names if name not in inside]
        if circle:
            shown = " → ".join(f"`{name}`" for name in self.circle(circle[0]))
            yield Fault(self.span(circle[0]), f"the joints lead in a circle: {shown}; nothing joins it to the root")

    def span(self, name: str) -> Span:
        return name_span(self.names[name])

    def reached(self, root: str) -> Iterator[str]:
        children: dict[str, list[str]] = {}
        for child, parent in self.parent.items():
            children.setdefault(parent, []).append(child)
        waiting = [root]
        while waiting:
            name = waiting.pop()
            yield name
            waiting += children.get(name, [])

    def circle(self, start: str) -> list[str]:
        found = [start]
        while (name := self.parent[found[-1]]) not in found:
            found.append(name)
        return [*found[found.index(name) :], name][::-1]
