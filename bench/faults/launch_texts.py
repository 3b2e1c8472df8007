"""Faults of launch files in XML and YAML."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache
from xml.etree import ElementTree

from bench.faults.fault import PutFault, Spot
from bench.faults.kinds import kind
from bench.faults.known import WELL_KNOWN, is_in_repository
from bench.faults.source_package import SourcePackage

XML = r"((^|/)launch/.*\.xml|\.launch\.xml|launch/.*\.launch)$"
YAML = r"((^|/)launch/.*\.ya?ml|\.launch\.ya?ml)$"


def frontend(package: SourcePackage, pattern: str, group: int = 1) -> Iterator[Spot]:
    """Yield the places in launch files of ROS 2 in XML."""
    for spot in package.spots(XML, pattern, group):
        is_of_ros1 = " type=" in spot.text or ("$(find " in spot.text and "$(find-pkg" not in spot.text)
        if "<launch" in spot.text and not is_of_ros1 and is_well_formed(spot.text):
            yield spot


@lru_cache(maxsize=200)
def is_well_formed(text: str) -> bool:
    """Return whether a file is right without a fault: one that is broken already hides all others."""
    try:
        ElementTree.fromstring(text)
    except ElementTree.ParseError:
        return False
    return True


@kind("launch xml")
def xml_mistyped_sibling(package: SourcePackage) -> Iterator[PutFault]:
    for spot in frontend(package, r"<(?:node|composable_node|node_container)\b[^>]*?\bpkg=\"(\w+)\""):
        if spot.word in package.siblings:
            yield spot.typo()


@kind("launch xml")
def xml_mistyped_package(package: SourcePackage) -> Iterator[PutFault]:
    for spot in frontend(package, r"<(?:node|composable_node|node_container)\b[^>]*?\bpkg=\"(\w+)\""):
        if spot.word not in package.siblings:
            yield spot.typo()


@kind("launch xml")
def xml_mistyped_executable(package: SourcePackage) -> Iterator[PutFault]:
    for spot in frontend(package, r"<node\b[^>]*?\bpkg=\"(\w+)\"[^>]*?\bexec=\"([\w.]+)\"", 2):
        if spot[1] in package.siblings:
            yield spot.typo()


@kind("launch xml")
def xml_without_executable(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("", "exec") for spot in frontend(package, r"<node\b[^>]*?\b(exec=\"[\w.]+\")"))


@kind("launch xml")
def xml_type_of_ros_1(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("type") for spot in frontend(package, r"<node\b[^>]*?\b(exec)=\""))


@kind("launch xml")
def xml_unclosed(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in frontend(package, r"(</(?:node|include|group)>)"))


@kind("launch xml")
def xml_quote_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in frontend(package, r"<arg name=\"\w+(\")"))


@kind("launch xml")
def xml_mistyped_tag(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("prama") for spot in frontend(package, r"<(param) [^>]*/>"))


@kind("launch xml")
def xml_mistyped_attribute(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("defualt") for spot in frontend(package, r"<arg name=\"\w+\"\s+(default)="))


@kind("launch xml")
def xml_param_without_value(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("", spot[1]) for spot in frontend(package, r"<param name=\"([\w.]+)\"( value=\"[^\"]*\")", 2))


@kind("launch xml")
def xml_mistyped_argument(package: SourcePackage) -> Iterator[PutFault]:
    for spot in frontend(package, r"\$\(var (\w+)\)"):
        if re.search(rf"<arg name=\"{spot.word}\"", spot.text):
            yield spot.typo()


@kind("launch xml")
def xml_argument_not_declared(package: SourcePackage) -> Iterator[PutFault]:
    for spot in frontend(package, r"^\s*<arg name=\"(\w+)\"[^>]*?default=[^>]*/>[ \t]*\n"):
        if re.search(rf"\$\(var {spot.word}\)", spot.text):
            name = re.escape(spot.path.rpartition("/")[2])
            given = rf"<include file=\"[^\"]*/{name}\"[^>]*>(?:(?!</include>)[\s\S])*?<arg name=\"{spot.word}\" value"
            yield spot.drop().known(not package.holds(XML, given), "whoever includes the file gives the argument")


@kind("launch xml")
def xml_arg_of_ros_1(package: SourcePackage) -> Iterator[PutFault]:
    for spot in frontend(package, r"\$\((var) (\w+)\)"):
        yield spot.put("arg", spot[2])


@kind("launch xml")
def xml_find_of_ros_1(package: SourcePackage) -> Iterator[PutFault]:
    for spot in frontend(package, r"\$\((find-pkg-share) (\w+)\)"):
        yield spot.put("find", spot[2])


@kind("launch xml")
def xml_mistyped_share(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in frontend(package, r"\$\(find-pkg-share (\w+)\)"))


@kind("launch xml")
def xml_mistyped_substitution(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("find-pkg-shar") for spot in frontend(package, r"\$\((find-pkg-share) \w+\)"))


@kind("launch xml")
def xml_substitution_not_closed(package: SourcePackage) -> Iterator[PutFault]:
    for spot in frontend(package, r"\$\((?:var|find-pkg-share) (\w+)(\))", 2):
        yield spot.put("", spot[1], spot.path.rpartition("/")[2])


@kind("launch xml")
def xml_mistyped_file(package: SourcePackage) -> Iterator[PutFault]:
    for spot in frontend(package, r"\$\(find-pkg-share (\w+)\)/(?:\w+/)*([\w.-]+\.\w+)", 2):
        if spot[1] == package.name and package.matching(rf"(^|/){re.escape(spot.word)}$"):
            yield spot.typo()


@kind("launch xml")
def xml_mistyped_include_argument(package: SourcePackage) -> Iterator[PutFault]:
    for spot in frontend(package, r"<include file=\"[^\"]*?([\w.-]+)\"[^>]*>\s*<arg name=\"(\w+)\" value", 2):
        if is_in_repository(package, spot[1]):
            yield spot.typo()


@kind("launch xml")
def xml_mistyped_component(package: SourcePackage) -> Iterator[PutFault]:
    for spot in frontend(package, r"<composable_node\b[^>]*?\bpkg=\"(\w+)\"[^>]*?\bplugin=\"(?:\w+::)+(\w+)\"", 2):
        if spot[1] in WELL_KNOWN or spot[1] in package.siblings:
            yield spot.typo()


@kind("launch xml")
def xml_remap_without_to(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("", "to", "remap") for spot in frontend(package, r"<remap from=\"[^\"]+\"( to=\"[^\"]*\")"))


@kind("launch xml")
def xml_name_twice(package: SourcePackage) -> Iterator[PutFault]:
    for spot in frontend(package, r"<node\b[^>]*?\b(name=\"\w+\")"):
        yield spot.put(f"{spot.word} {spot.word}", "name", spot.path.rpartition("/")[2])


@kind("launch yaml")
def yaml_mistyped_package(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in package.spots(YAML, r"^\s*-?\s*pkg:\s*['\"]?(\w+)"))


@kind("launch yaml")
def yaml_mistyped_executable(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(YAML, r"^\s*-?\s*exec:\s*['\"]?(\w+)"):
        beside = re.findall(
            r"\bpkg:\s*['\"]?(\w+)", spot.text[max(spot.match.start() - 200, 0) : spot.match.end() + 200]
        )
        is_known = any(each in package.siblings or each in WELL_KNOWN for each in beside)
        yield spot.typo().known(is_known, "the programs of a package that is not here")


@kind("launch yaml")
def yaml_mistyped_key(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("pakg") for spot in package.spots(YAML, r"^\s*-?\s*(pkg):\s"))


@kind("launch yaml")
def yaml_mistyped_argument(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in package.spots(YAML, r"\$\(var (\w+)\)"))


@kind("launch yaml")
def yaml_colon_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in package.spots(YAML, r"^- (?:node|include|arg)(:)"))
