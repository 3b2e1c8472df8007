"""Faults of robot descriptions in urdf and xacro."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bench.faults.aside import used_kind
from bench.faults.fault import PutFault, Spot
from bench.faults.source_package import SourcePackage

FILES = r"\.(urdf|xacro)$"
urdf_kind = used_kind("urdf")
LITERAL = r"[\w-]+"
NOT_HERE = "a file that is included and not here may define it"


def own(package: SourcePackage, pattern: str, group: int = 1) -> Iterator[Spot]:
    for spot in package.spots(FILES, pattern, group):
        if "<robot" in spot.text:
            yield spot


@urdf_kind
def urdf_mistyped_child(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, rf"<child\s+link\s*=\s*\"({LITERAL})\""):
        if re.search(rf"<link\s+name\s*=\s*\"{spot.word}\"", spot.text):
            yield spot.typo()


@urdf_kind
def urdf_mistyped_parent(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, rf"<parent\s+link\s*=\s*\"({LITERAL})\""):
        if re.search(rf"<link\s+name\s*=\s*\"{spot.word}\"", spot.text):
            yield spot.typo()


@urdf_kind
def urdf_link_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, rf"^\s*<link\s+name\s*=\s*\"({LITERAL})\"\s*/>[ \t]*\n"):
        if re.search(rf"link\s*=\s*\"{spot.word}\"", spot.text):
            yield spot.drop().known(has_all_included(package, spot), NOT_HERE)


def has_all_included(package: SourcePackage, spot: Spot) -> bool:
    """Return whether the files that a robot includes of packages are those of the repository."""
    found = re.findall(r"<xacro:include[^>]*filename\s*=\s*\"\$\(find ([^)]*)\)", spot.text)
    return all(each in package.siblings for each in found)


@urdf_kind
def urdf_link_twice(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, rf"(<link\s+name\s*=\s*\"({LITERAL})\"\s*/>)"):
        yield spot.put(spot.word * 2, spot[2])


@urdf_kind
def urdf_mistyped_joint_type(package: SourcePackage) -> Iterator[PutFault]:
    yield from (
        spot.typo() for spot in own(package, r"<joint\b[^>]*?\btype\s*=\s*\"(fixed|continuous|revolute|prismatic)\"")
    )


@urdf_kind
def urdf_without_joint_type(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, rf"<joint name\s*=\s*\"({LITERAL})\"(\s+type\s*=\s*\"fixed\")", 2):
        yield spot.put("", "type", spot[1])


@urdf_kind
def urdf_without_limit(package: SourcePackage) -> Iterator[PutFault]:
    moving = r"<joint name\s*=\s*\"([^\"]+)\"\s+type\s*=\s*\"(?:revolute|prismatic)\">"
    pattern = rf"{moving}(?:(?!</joint>)[\s\S])*?(<limit[^>]*/>)"
    for spot in own(package, pattern, 2):
        yield spot.put("", "limit", spot[1])


@urdf_kind
def urdf_mistyped_mesh(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(
        package,
        r"filename\s*=\s*\"(?:package://|file://\$\(find )([\w-]+)\)?/(?:[\w-]+/)*([\w-]+\.(?:stl|dae|STL|DAE|obj))\"",
        2,
    ):
        if spot[1] in package.siblings and package.matching(rf"/{re.escape(spot.word)}$"):
            yield spot.typo()


@urdf_kind
def urdf_mistyped_mesh_package(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in own(package, r"filename\s*=\s*\"package://(\w+)/"))


@urdf_kind
def urdf_mesh_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(
        package, rf"filename\s*=\s*\"(?:package://|file://\$\(find ){package.name}\)?/([\w/-]+\.(?:stl|dae|STL|DAE))\""
    ):
        if spot.word in package.files:
            yield package.removed(spot.word)


@urdf_kind
def urdf_unclosed(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in own(package, r"(</(?:link|joint|visual)>)"))


@urdf_kind
def urdf_quote_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in own(package, r"<link\s+name\s*=\s*\"[^\"\n]+(\")"))


@urdf_kind
def urdf_mistyped_mimic(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in own(package, r"<mimic\s+joint\s*=\s*\"(?:\$\{\w+\})?(\w+)\""))


@urdf_kind
def urdf_mistyped_gazebo_reference(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, rf"<gazebo\s+reference\s*=\s*\"({LITERAL})\""):
        if re.search(rf"<link\s+name\s*=\s*\"{spot.word}\"", spot.text):
            yield spot.typo()


@urdf_kind
def urdf_mistyped_control_joint(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, rf"<ros2_control\b(?:(?!</ros2_control>)[\s\S])*?<joint name\s*=\s*\"({LITERAL})\""):
        if len(re.findall(rf"<joint\s+name\s*=\s*\"{spot.word}\"", spot.text)) > 1:
            yield spot.typo()


@urdf_kind
def urdf_numbers_missing(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"xyz\s*=\s*\"(-?[\d.]+ -?[\d.]+( -?[\d.]+))\"", 2):
        yield spot.put("", "xyz", spot[1])


@urdf_kind
def urdf_letter_in_number(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"(xyz|rpy)\s*=\s*\"((-?\d+[\d.]*) -?[\d.]+ -?[\d.]+)\"", 3):
        yield spot.put("O.1", spot[1])


@urdf_kind
def urdf_comma_in_numbers(package: SourcePackage) -> Iterator[PutFault]:
    for spot in own(package, r"(xyz|rpy)\s*=\s*\"-?[\d.]+( )-?[\d.]+ -?[\d.]+\"", 2):
        yield spot.put(", ", spot[1])


@urdf_kind
def urdf_mistyped_plugin(package: SourcePackage) -> Iterator[PutFault]:
    known = {*package.siblings, "gz_ros2_control", "mock_components", "fake_components"}
    for spot in own(package, r"<plugin>(\w+)/(\w+)</plugin>", 2):
        yield spot.typo().known(spot[1] in known, "the plugins of a package that is not here, and in no table")
