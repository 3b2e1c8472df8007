"""What urdfdom, xacro and the nodes that read a robot description would refuse of one file."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from ...languages.xml.parser import Document, Element
from ...package.urdf.reader import ROBOTS
from ...package.urdf.references import text_spans
from ...package.urdf.robot_file import RobotFile
from ...source import Span
from ...suggest import did_you_mean
from ..fault import Fault, Level, joined
from .element_attributes import first
from .joint_check import JointCheck
from .kinematic_tree import KinematicTree
from .link_check import LinkCheck
from .loose_parts import loose_faults
from .repeated_names import is_named_only, repeated, repeated_in_blocks
from .robot_words import control_faults, misspelt_parts
from .substitutions import substitution_fault
from .xacro_calls import XacroCalls
from .xacro_slips import is_expanded, xacro_slips

HARMLESS = frozenset({"xacro:property", "xacro:arg"})
"""Elements of xacro that add no links."""
VERSIONS = ("1.0", "1.1", "1.2")
VAIN = ": ros2_control looks for it in vain"
"""That of Jazzy and later stops there; an older one starts, and nothing moves."""


def robot_faults(robot: RobotFile, calls: XacroCalls | None = None) -> list[Fault]:
    """Return what is wrong with a robot in URDF or xacro, by position; worlds (.sdf, .world) are not judged.

    Where the calls of its package are given, what xacro evaluates only for some has a lower level.
    """
    if not robot.path.endswith(ROBOTS):
        return []
    piece = robot.path.endswith(".xacro") and not (calls and calls.includes.is_robot(robot))
    piece = piece or (calls is not None and calls.includes.is_part(robot.document))
    found = sorted(unsorted_faults(robot, piece), key=lambda fault: fault.span)
    if calls is None or not robot.is_xacro:
        return found
    return [calls.weighed(robot.document.root, fault) for fault in found]


def unsorted_faults(robot: RobotFile, piece: bool) -> Iterator[Fault]:
    document, links = robot.document, robot.links
    joints = [joint for joint in robot.joints if not (robot.is_xacro and is_named_only(joint))]
    root = document.root
    if robot.path.endswith(".xacro") or "<xacro:" in document.source.text:
        yield from substitution_faults(document)
        yield from xacro_slips(root, robot.path)
    if root.tag != "robot":
        if not robot.is_xacro:
            yield Fault(root.open, f"the root of a URDF is `<robot>`, not `<{root.tag}>`: urdfdom refuses it")
        return
    expanded = is_expanded(root, robot.path)
    check, link_check = JointCheck(document.source, is_xacro=expanded), LinkCheck(document.source, is_xacro=expanded)
    if robot.is_xacro:
        yield from loose_faults(root, check)
    yield from control_faults(root)
    yield from repeated_in_blocks(root)
    if not links and not joints:
        return  # part of a robot, for other files to include
    for link in links:
        yield from link_check.link(link)
    for joint in joints:
        yield from check.joint(joint)
        yield from check.to_itself(joint)
    yield from (fault for part in (*links, *joints) for fault in misspelt_parts(part))
    yield from repeated(root, "link")
    yield from repeated(root, "joint", joints)
    if is_whole(root, (*links, *joints)):
        if not (robot.is_xacro or piece):
            yield from robot_element(root)
        yield from KinematicTree(root, links, joints).faults(piece=piece or document.source.path.endswith(".xacro"))
        if not piece:
            yield from named_joints(root, joints)
    else:
        yield from (fault for joint in joints for fault in check.ends(joint))


def robot_element(root: Element) -> Iterator[Fault]:
    if root.get("name") is None:
        yield Fault(root.open, "`<robot>` has no `name`: urdfdom refuses it")
    version = root.attributes.get("version")
    if version is not None and version.value not in VERSIONS:
        yield Fault(version.value_span, f"`{version.value}` is no version of URDF: 1.0")
    yield from repeated(root, "material")


def is_whole(root: Element, parts: Sequence[Element]) -> bool:
    """Return whether all links and joints of a robot are in the file, with literal names."""
    if any(element.tag.startswith("xacro:") and element.tag not in HARMLESS for element in root.walk()):
        return False
    ends = [end for part in parts for end in part.children if end.tag in ("parent", "child")]
    values = [*(part.get("name") for part in parts), *(end.get("link") for end in ends)]
    return all(value is None or "$" not in value for value in values)


def named_joints(root: Element, joints: Sequence[Element]) -> Iterator[Fault]:
    """Yield the joints that a <mimic> or a <ros2_control> names, and that the robot lacks."""
    names = {joint.get("name") or "" for joint in joints}
    mimics = [mimic.attributes.get("joint") for joint in joints if (mimic := first(joint, "mimic"))]
    controls = [part for part in root.children if part.tag == "ros2_control"]
    others = [each.attributes.get("name") for part in controls for each in part.children if each.tag == "joint"]
    level: Level | None
    for group, harm, level in ((mimics, "", None), (others, VAIN, "warning")):
        lost = [each for each in group if each and each.value not in names and "$" not in each.value]
        if lost:
            start = f"no joint of the robot is called `{lost[0].value}`{did_you_mean(lost[0].value, names)}{harm}"
            yield one_fault([Fault(each.value_span, start, level) for each in lost])


def one_fault(lost: Sequence[Fault]) -> Fault:
    """Return names of one file that are not there as one fault, at the first, which says how many others there are."""
    count = len(lost) - 1
    more = f"; {count} more {'are' if count > 1 else 'is'} not there either" if count else ""
    return joined(lost, f"{lost[0].message}{more}", "")


def substitution_faults(document: Document) -> Iterator[Fault]:
    source = document.source
    for element in document.root.walk():
        found = [(attribute.value_span, True) for attribute in element.attributes.values()]
        found += (
            [(span, False) for span in text_spans(element)] if element.chunks and not element.is_self_closing else []
        )
        for span, flat in found:
            text = source.slice(span)
            text = re.sub(r"\s", " ", text) if flat else text  # XML makes one line of an attribute
            if (at := text.find("package://$(find ")) >= 0:
                message = "`$(find …)` is an absolute path already: write `package://name/…` or `file://$(find name)/…`"
                yield Fault(Span(span.start + at, span.start + at + len("package://$(find")), message)
            if "$" in text and "&" not in text and (fault := substitution_fault(text)):
                start, end, message = fault
                yield Fault(Span(span.start + start, span.start + end), f"{message}; xacro stops here")
