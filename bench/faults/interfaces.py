"""Faults of interface files."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import wraps

from bench.faults.fault import PutFault
from bench.faults.kinds import Places, kind
from bench.faults.source_package import SourcePackage

FILES = r"^(msg|srv|action)/\w+\.(msg|srv|action)$"
CMAKE = r"(^|/)CMakeLists\.txt$|\.cmake$"
UNUSED = "nothing generates code of this file"
PLAIN = r"(?:bool|byte|char|float32|float64|u?int(?:8|16|32|64)|string)"


def interface_kind(places: Places) -> Places:
    """Register a kind whose faults are excluded in files that CMake names in a comment alone, or nowhere."""

    @wraps(places)
    def weighed(package: SourcePackage) -> Iterator[PutFault]:
        for fault in places(package):
            name = re.escape(fault.path.rpartition("/")[2].partition(".")[0])
            is_listed = package.holds(CMAKE, rf"\b{name}\b|GLOB")
            listed = package.words(CMAKE, rf"([\w/]+/{name}\.(?:msg|srv|action))\b")
            is_another = bool(listed) and not any(fault.path.endswith(f"/{each}") for each in listed)
            fault = fault.known(not is_another, "CMake lists another file of that name")
            yield fault.known(is_listed and package.holds(CMAKE, r"rosidl|generate_interfaces"), UNUSED)

    return kind("interfaces")(weighed)


@interface_kind
def interface_mistyped_plain_type(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in package.spots(FILES, rf"^({PLAIN})(?:\[\d*\])?[ \t]+\w+"))


@interface_kind
def interface_capital_type(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(FILES, rf"^({PLAIN})[ \t]+\w+"):
        yield spot.put(spot.word.capitalize())


@interface_kind
def interface_mistyped_foreign_type(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in package.spots(FILES, r"^[a-z]\w+/(?:msg/)?([A-Z]\w+)(?:\[\d*\])?[ \t]+\w+"))


@interface_kind
def interface_mistyped_foreign_package(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in package.spots(FILES, r"^([a-z]\w+)/(?:msg/)?[A-Z]\w+(?:\[\d*\])?[ \t]+\w+"))


@interface_kind
def interface_mistyped_own_type(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in package.spots(FILES, r"^([A-Z][a-z]\w+)(?:\[\d*\])?[ \t]+\w+"))


@interface_kind
def interface_type_without_package(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(FILES, r"^([a-z]\w+/(?:msg/)?)([A-Z]\w+)(?:\[\d*\])?[ \t]+\w+"):
        if spot[2] != "Header" and not spot.word.startswith(package.name):
            yield spot.put("", spot[2])


@interface_kind
def interface_capital_field(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(FILES, r"^[\w/]+(?:\[\d*\])?[ \t]+([a-z]\w+)[ \t]*$"):
        yield spot.put(spot.word.capitalize())


@interface_kind
def interface_dash_in_field(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(FILES, r"^[\w/]+(?:\[\d*\])?[ \t]+([a-z]+_\w+)[ \t]*$"):
        yield spot.put(spot.word.replace("_", "-", 1))


@interface_kind
def interface_field_twice(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(FILES, r"^([\w/]+(?:\[\d*\])?[ \t]+([a-z]\w+))[ \t]*$"):
        yield spot.put(f"{spot.word}\n{spot.word}", spot[2])


@interface_kind
def interface_field_without_type(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("", spot[2]) for spot in package.spots(FILES, rf"^({PLAIN}[ \t]+)([a-z]\w+)[ \t]*$"))


@interface_kind
def interface_with_semicolon(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(FILES, r"^[\w/]+(?:\[\d*\])?[ \t]+([a-z]\w+)[ \t]*$"):
        yield spot.put(f"{spot.word};")


@interface_kind
def interface_array_on_name(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(FILES, r"^([\w/]+)\[\][ \t]+(\w+)[ \t]*$", 0):
        yield spot.put(f"{spot[1]} {spot[2]}[]", spot[2])


@interface_kind
def interface_separator_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in package.spots(r"\.(srv|action)$", r"^(---)$"))


@interface_kind
def interface_short_separator(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("--") for spot in package.spots(r"\.(srv|action)$", r"^(---)$"))


@interface_kind
def interface_lower_constant(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(FILES, rf"^{PLAIN}[ \t]+([A-Z][A-Z0-9_]+)[ \t]*="):
        yield spot.put(spot.word.lower())


@interface_kind
def interface_constant_of_other_type(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(FILES, r"^u?int\d+[ \t]+([A-Z][A-Z0-9_]+)[ \t]*=[ \t]*(\d+)", 2):
        yield spot.put("abc", spot[1])


@interface_kind
def interface_constant_too_big(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(FILES, r"^u?int8[ \t]+([A-Z][A-Z0-9_]+)[ \t]*=[ \t]*(\d+)", 2):
        yield spot.put("300", spot[1])


@interface_kind
def interface_default_with_equals(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(FILES, rf"^{PLAIN}[ \t]+([a-z]\w+)()[ \t]*$", 2):
        yield spot.put("=1", spot[1])


@interface_kind
def interface_lower_file(package: SourcePackage) -> Iterator[PutFault]:
    for file in package.matching(FILES):
        folder, _, name = file.rpartition("/")
        if not package.matching(rf"/{name.lower()}$"):
            yield package.renamed(file, f"{folder}/{name.lower()}", name.partition(".")[0])


@kind("interfaces", is_seen_outside=True)
def interface_renamed(package: SourcePackage) -> Iterator[PutFault]:
    for file in package.matching(FILES):
        stem, _, ending = file.rpartition(".")
        if package.holds("^CMakeLists.txt$", file):
            yield package.renamed(file, f"{stem}2.{ending}", stem.rpartition("/")[2])


@interface_kind
def interface_in_other_folder(package: SourcePackage) -> Iterator[PutFault]:
    for file in package.matching(r"^msg/\w+\.msg$"):
        if package.holds("^CMakeLists.txt$", file):
            yield package.renamed(file, file.replace("msg/", "msgs/", 1))
