"""Faults of parameter files."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bench.faults.fault import PutFault, Spot
from bench.faults.kinds import kind
from bench.faults.source_package import SourcePackage

FILES = r"^(?!test|doc).*\.ya?ml$"
SOURCES = r"\.(cpp|hpp|py|h)$"


def inside(package: SourcePackage, pattern: str, group: int = 1) -> Iterator[Spot]:
    """Yield the places in parameter files of nodes."""
    for spot in package.spots(FILES, pattern, group):
        if "ros__parameters" in spot.text:
            yield spot


def declared(package: SourcePackage, values: str) -> Iterator[Spot]:
    """Yield the lines of parameters that the package's sources declare by a literal name."""
    names = package.words(SOURCES, r"declare_parameter(?:<[\w:<>]+>)?\(\s*['\"](\w+)['\"]")
    for spot in inside(package, rf"^[ \t]+(\w+):[ \t]+({values})[ \t]*$", 2):
        if spot[1] in names:
            yield spot


@kind("parameters")
def params_mistyped_ros_parameters(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("ros_parameters") for spot in inside(package, r"^\s*(ros__parameters):"))


@kind("parameters")
def params_without_ros_parameters(package: SourcePackage) -> Iterator[PutFault]:
    for spot in inside(package, r"^\s*(ros__parameters):[ \t]*\n"):
        yield spot.drop(spot.path.rpartition("/")[2])


@kind("parameters")
def params_mistyped_node(package: SourcePackage) -> Iterator[PutFault]:
    for spot in inside(package, r"^/?(\w+):[ \t]*\n\s+ros__parameters:"):
        if package.holds(r"\.(py|cpp|hpp|xml)$", rf"['\"]{spot.word}['\"]"):
            yield spot.typo()


@kind("parameters")
def params_mistyped_name(package: SourcePackage) -> Iterator[PutFault]:
    names = package.words(SOURCES, r"declare_parameter(?:<[\w:<>]+>)?\(\s*['\"](\w+)['\"]")
    yield from (spot.typo() for spot in inside(package, r"^[ \t]+(\w+):[ \t]+\S") if spot.word in names)


@kind("parameters")
def params_number_as_text(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put(f'"{spot.word}"', spot[1]) for spot in declared(package, r"-?\d+\.\d+"))


@kind("parameters")
def params_whole_number_for_double(package: SourcePackage) -> Iterator[PutFault]:
    for spot in declared(package, r"-?\d+\.\d+"):
        yield spot.put(spot.word.partition(".")[0], spot[1])


@kind("parameters")
def params_double_for_whole_number(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put(f"{spot.word}.5", spot[1]) for spot in declared(package, r"-?\d+"))


@kind("parameters")
def params_truth_as_text(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put(f'"{spot.word}"', spot[1]) for spot in declared(package, r"[Tt]rue|[Ff]alse"))


@kind("parameters")
def params_text_as_truth(package: SourcePackage) -> Iterator[PutFault]:
    yield from (
        spot.put("true", spot[1])
        for spot in declared(package, r"['\"]?[a-z]\w+['\"]?")
        if "true" not in spot.word.lower() and "false" not in spot.word.lower()
    )


@kind("parameters")
def params_tab(package: SourcePackage) -> Iterator[PutFault]:
    for spot in inside(package, r"^([ ]{2,})\w+:"):
        yield spot.of_file("\t")


@kind("parameters")
def params_colon_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in inside(package, r"^\s*ros__parameters(:)"):
        yield spot.of_file("")


@kind("parameters")
def params_space_after_colon_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in inside(package, r"^[ \t]+(\w+):( )[\w.\"'-]+[ \t]*$", 2):
        yield spot.put("", spot.path.rpartition("/")[2], spot[1])


@kind("parameters")
def params_wrong_indentation(package: SourcePackage) -> Iterator[PutFault]:
    for spot in inside(package, r"^[ ]{4,}\w+:[ ][^\n\[{|>&]+\n()[ ]{4,}\w+:[ ]"):
        yield spot.of_file("   ")


@kind("parameters")
def params_twice(package: SourcePackage) -> Iterator[PutFault]:
    for spot in inside(package, r"^([ \t]+(\w+):[ \t]+[\w.\"'-]+)[ \t]*$"):
        yield spot.put(f"{spot.word}\n{spot.word}", spot[2])


@kind("parameters")
def params_mixed_list(package: SourcePackage) -> Iterator[PutFault]:
    for spot in inside(package, r"^\s+(\w+):[ \t]*\[\s*-?\d+\.\d+\s*,\s*(-?\d+\.\d+)", 2):
        yield spot.put('"a"', spot[1])


@kind("parameters")
def params_whole_number_in_double_list(package: SourcePackage) -> Iterator[PutFault]:
    for spot in inside(package, r"^\s+(\w+):[ \t]*\[\s*-?\d+\.\d+\s*,\s*(-?\d+\.\d+)", 2):
        yield spot.put("1", spot[1])


@kind("parameters")
def params_bracket_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in inside(package, r":[ \t]*\[[^\[\]\n]+(\])[ \t]*$"))


@kind("parameters")
def params_quote_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in inside(package, r":[ \t]+\"[^\"\n]*(\")[ \t]*$"))


@kind("parameters")
def params_plugin_list_mistyped(package: SourcePackage) -> Iterator[PutFault]:
    for spot in inside(package, r"_plugins:[ \t]*\[\s*['\"]?(\w+)"):
        if re.search(rf"^\s+{spot.word}:[ \t]*$", spot.text, re.MULTILINE):
            yield spot.typo()


@kind("parameters")
def params_null_value(package: SourcePackage) -> Iterator[PutFault]:
    for spot in declared(package, r"-?\d+\.\d+|[\w.'\"-]+"):
        yield spot.put("", spot[1])


@kind("parameters")
def params_mistyped_controller(package: SourcePackage) -> Iterator[PutFault]:
    for spot in inside(package, r"^(\w+):[ \t]*\n\s+ros__parameters:"):
        if re.search(rf"^\s{{2,}}{spot.word}:\s*\n\s+type:", spot.text, re.MULTILINE):
            yield spot.typo()


@kind("parameters")
def params_file_conflict_markers(package: SourcePackage) -> Iterator[PutFault]:
    for spot in inside(package, r"^([ \t]+\w+:[ \t]+[\w.\"'-]+)\n"):
        yield spot.of_file(f"<<<<<<< HEAD\n{spot.word}\n=======\n>>>>>>> main")
