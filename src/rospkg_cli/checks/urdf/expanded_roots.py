"""Links that no joint joins to the rest of a robot, as xacro leaves it: urdfdom refuses two roots."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.urdf.expansion.expansion import Node
from ...package.urdf.expansion.values import XacroUnknown, shown
from ..fault import Fault
from .expanded_places import Found, own_place
from .expanded_tree import ExpandedTree, name_of


def split_faults(tree: ExpandedTree) -> Iterator[Found]:
    """Yield the roots of a robot but for that of most of its links; none where a part of it may be elsewhere."""
    if not tree.is_robot or tree.expansion.is_open or not is_known(tree):
        return
    children = links_below(tree.joints)
    roots = [link for link in tree.links if link.is_certain and name_of(link) not in children]
    if (
        len(roots) < 2 or not children or len(set(children)) < len(children)
    ):  # a link that is the child of two joints has its own finding
        return
    sizes = {name_of(root): size(name_of(root), tree.joints) for root in roots}
    main = max(sizes, key=lambda name: sizes[name])
    for root in roots:
        name = name_of(root)
        place = own_place(root, root.attributes["name"].span, name) if name != main else None
        if place is not None:
            message = f"no joint joins `{name}` to `{main}`: a robot has one root, and urdfdom refuses two"
            yield place[0].path, Fault(place[1], message)


def is_known(tree: ExpandedTree) -> bool:
    """Return whether all names are known, and every joint has both of its ends."""
    given = [end and end.attributes.get("link") for joint in tree.joints for end in ends(joint)]
    return not tree.has_unknown_names and all(each and not isinstance(each.value, XacroUnknown) for each in given)


def ends(joint: Node) -> tuple[Node | None, Node | None]:
    return joint.first("parent"), joint.first("child")


def links_below(joints: list[Node]) -> list[str]:
    found = (joint.first("child") for joint in joints if joint.is_certain)
    sure = [shown(end.attributes["link"].value) for end in found if end is not None]
    perhaps = {shown(end.attributes["link"].value) for joint in joints if (end := joint.first("child")) is not None}
    return [*sure, *sorted(perhaps - set(sure))]


def size(root: str, joints: list[Node]) -> int:
    """Return how many links hang on one."""
    below: dict[str, list[str]] = {}
    for joint in joints:
        parent, child = ends(joint)
        if parent is not None and child is not None:
            below.setdefault(shown(parent.attributes["link"].value), []).append(shown(child.attributes["link"].value))
    waiting, seen = [root], set[str]()
    while waiting:
        name = waiting.pop()
        if name not in seen:
            seen.add(name)
            waiting += below.get(name, [])
    return len(seen)
