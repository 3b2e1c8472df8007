"""Faults of the tree that links and joints make, and of what simulators and controllers read of it."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bench.faults.fault import PutFault
from bench.faults.source_package import SourcePackage
from bench.faults.urdf import LITERAL, own, urdf_kind

JOINT = rf"^\s*<joint\s+name\s*=\s*\"({LITERAL})\"\s+type\s*=\s*\"\w+\"\s*>(?:(?!</joint>)[\s\S])*?</joint>[ \t]*\n"


@urdf_kind
def urdf_joint_without_parent(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, rf"<joint\s+name\s*=\s*\"({LITERAL})\"[^>]*>\s*(<parent\s[^>]*/>)", 2):
        yield spot.put("", spot[1], "parent")


@urdf_kind
def urdf_joint_without_child(package: SourcePackage) -> Iterator[PutFault]:
    pattern = rf"<joint\s+name\s*=\s*\"({LITERAL})\"[^>]*>(?:(?!</joint>)[\s\S])*?(<child\s[^>]*/>)"
    for spot in own(package, pattern, 2):
        yield spot.put("", spot[1], "child")


@urdf_kind
def urdf_joint_twice(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, JOINT, 0):
        yield spot.put(spot.word * 2, spot[1])


@urdf_kind
def urdf_joint_lost(package: SourcePackage) -> Iterator[PutFault]:
    """Without the joint the robot has two roots."""
    for spot in own(package, JOINT, 0):
        child = re.search(rf"<child\s+link\s*=\s*\"({LITERAL})\"", spot.word)
        is_whole = "xacro:include" not in spot.text and "xacro:macro" not in spot.text
        if child and is_whole and len(re.findall(rf"<child\s+link\s*=\s*\"{child[1]}\"", spot.text)) == 1:
            yield spot.put("", child[1], spot[1])


@urdf_kind
def urdf_child_of_itself(package: SourcePackage) -> Iterator[PutFault]:
    pattern = rf"<parent\s+link\s*=\s*\"({LITERAL})\"\s*/>\s*<child\s+link\s*=\s*\"({LITERAL})\""
    for spot in own(package, pattern, 2):
        if re.search(rf"<link\s+name\s*=\s*\"{spot[1]}\"", spot.text):
            yield spot.put(spot[1], spot[2])


@urdf_kind
def urdf_mesh_in_other_case(package: SourcePackage) -> Iterator[PutFault]:
    pattern = r"filename\s*=\s*\"package://([\w-]+)/(?:[\w-]+/)*([\w-]+\.(stl|dae|STL|DAE))\""
    for spot in own(package, pattern, 3):
        if spot[1] in package.siblings and any((package.repository / package.siblings[spot[1]]).rglob(spot[2])):
            yield spot.put(spot.word.swapcase(), spot[2])


@urdf_kind
def urdf_mistyped_interface_of_joint(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"<(?:command|state)_interface\s+name\s*=\s*\"(position|velocity|effort)\""):
        yield spot.typo()


@urdf_kind
def urdf_mistyped_type_of_control(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"<ros2_control\b[^>]*?\btype\s*=\s*\"(system|sensor|actuator)\""):
        yield spot.typo()


@urdf_kind
def urdf_mistyped_shape(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"<(box|cylinder|sphere)\s[^>]*/>"):
        yield spot.typo()


@urdf_kind
def urdf_inertia_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"<inertia\s[^>]*?(\s+izz\s*=\s*\"[^\"]*\")"):
        yield spot.put("", "izz", "inertia")


@urdf_kind
def urdf_mistyped_tag(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"<(visual|collision|inertial)>(?=(?:(?!</\1>)[\s\S])*</(\1)>)"):
        wrong = spot.word[:-1]
        end = spot.text.find(f"</{spot.word}>", spot.match.end())
        text = spot.text[: spot.match.start(1)] + wrong + spot.text[spot.match.end(1) : end]
        yield spot.rewritten(f"{text}</{wrong}>{spot.text[end + len(spot.word) + 3 :]}", wrong, spot.word)
