"""Faults of sources in C++."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bench.faults.aside import used_kind
from bench.faults.fault import PutFault
from bench.faults.kinds import kind
from bench.faults.known import UNKNOWN, has_known_interfaces
from bench.faults.source_package import SourcePackage

CPP = r"^(?!test/).*\.(cpp|hpp|cc|h)$"


@kind("c++")
def cpp_mistyped_own_header(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CPP, rf"^#include\s*[<\"]{package.name}/((?:\w+/)*\w+\.hp?p?)[>\"]"):
        if package.matching(rf"{package.name}/{spot.word}$"):
            yield spot.typo(spot.word.rpartition("/")[2])


@kind("c++", is_seen_outside=True)
def cpp_own_header_renamed(package: SourcePackage) -> Iterator[PutFault]:
    for file in package.matching(rf"^include/.*{package.name}/\w+\.hpp$"):
        name = file.rpartition("/")[2]
        if package.holds(CPP, rf"#include\s*[<\"]{package.name}/{name}"):
            yield package.renamed(file, file.replace(".hpp", "_2.hpp"))


@kind("c++")
def cpp_mistyped_header_of_sibling(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CPP, r"^#include\s*[<\"](\w+)/((?:\w+/)*\w+\.hp?p?)[>\"]", 2):
        folder = package.siblings.get(spot[1])
        if spot[1] == package.name or folder is None or "/msg/" in spot.match[0]:
            continue
        if any((package.repository / folder).glob(f"include/**/{spot[1]}/{spot.word}")):
            yield spot.typo(spot.word.rpartition("/")[2])


@kind("c++")
def cpp_mistyped_header_of_interface(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CPP, r"^#include\s*[<\"](\w+)/(?:msg|srv|action)/(\w+)\.hpp[>\"]", 2):
        yield spot.typo(f"{spot.word}.hpp").known(has_known_interfaces(package, spot[1]), UNKNOWN)


@kind("c++")
def cpp_header_of_interface_by_class(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CPP, r"^#include\s*[<\"]\w+/(?:msg|srv|action)/(\w+_\w+)\.hpp[>\"]"):
        new = "".join(part.capitalize() for part in spot.word.split("_"))
        yield spot.put(new, f"{spot.word}.hpp", f"{new}.hpp")


@kind("c++")
def cpp_mistyped_include_package(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CPP, r"^#include\s*[<\"]([a-z0-9]+_\w+)/(?:\w+/)*\w+\.hp?p?[>\"]"):
        if spot.word in package.siblings or "/msg/" in spot.match[0]:
            yield spot.typo()


@kind("c++")
def cpp_mistyped_message_type(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(r"\.cpp$", r"\b(\w+_msgs)::(?:msg|srv)::([A-Z]\w+)\b", 2):
        yield spot.typo().known(has_known_interfaces(package, spot[1]), UNKNOWN)


@kind("c++")
def cpp_mistyped_field(package: SourcePackage) -> Iterator[PutFault]:
    fields = r"header|stamp|frame_id|pose|position|orientation|twist|linear|angular|ranges|covariance"
    for spot in package.spots(r"\.cpp$", rf"(?<![\w.>:])(\w+)(?:->|\.)({fields})\b(?!\s*\()", 2):
        declared = rf"_msgs::msg::\w+(?:::\w+Ptr)?(?:\s+const)?\s*[\s&]\s*{spot[1]}\b"
        if re.search(declared, spot.text):
            yield spot.typo()


@kind("c++")
def cpp_include_of_ros_1(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("ros/ros.h") for spot in package.spots(CPP, r"^#include\s*[<\"](rclcpp/rclcpp\.hpp)[>\"]"))


@kind("c++")
def cpp_undeclared_parameter(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(r"\.cpp$", r"\bget_parameter\(\s*\"([\w.]+)\""):
        if re.search(rf"declare_parameter(?:<[\w:<>]+>)?\(\s*\"{re.escape(spot.word)}\"", spot.text):
            yield spot.typo()


@used_kind("c++")
def cpp_mistyped_share(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in package.spots(CPP, r"get_package_share_directory\(\s*\"(\w+)\""))


@kind("c++")
def cpp_source_renamed(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(r"^CMakeLists\.txt$", r"\b(src/\w+\.cpp)\b"):
        if spot.word in package.files:
            yield package.renamed(spot.word, spot.word.replace(".cpp", "_node2.cpp"))
