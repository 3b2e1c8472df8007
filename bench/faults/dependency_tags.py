"""Faults of the tags that hold dependencies, and dependencies of a wrong kind."""

from __future__ import annotations

from collections.abc import Iterator

from bench.faults.cmake_stop import brought_by
from bench.faults.dependencies import CMAKE, DEPEND, LAUNCH, OWN_PYTHON, SOURCES, XML
from bench.faults.fault import PutFault, Spot
from bench.faults.kinds import kind
from bench.faults.source_package import SourcePackage


@kind("manifest")
def depends_in_one_tag(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<(\w*depend)>([\w-]+(</\1>\s*<\1>)[\w-]+)</\1>", 3):
        yield spot.put(", ", *spot[2].replace(spot.word, " ").split())


@kind("manifest")
def depend_empty(package: SourcePackage) -> Iterator[PutFault]:
    """One that names nothing, beside one that stays."""
    for spot in package.spots(XML, DEPEND):
        tag = tag_of(spot)
        yield spot.put(f"{spot.word}</{tag}>\n  <{tag}>", "empty", tag, "names nothing")


@kind("manifest")
def depend_twice(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"^(\s*<(\w*depend)>([\w-]+)</\2>)[ \t]*$"):
        yield spot.put(f"{spot.word}\n{spot.word.strip(chr(10))}", spot[3])


@kind("manifest")
def depend_and_build_depend(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"(<depend>([\w-]+)</depend>)"):
        yield spot.put(f"{spot.word}\n  <build_depend>{spot[2]}</build_depend>", spot[2])


@kind("manifest")
def depend_on_itself(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<(?:exec_)?depend>([\w-]+)</\w+>"):
        tag = tag_of(spot)
        yield spot.put(f"{spot.word}</{tag}>\n  <{tag}>{package.name}", "itself", package.name)


def tag_of(spot: Spot) -> str:
    return spot.match[0].partition(">")[0][1:].split()[0]


def changed_tag(spot: Spot, new: str) -> PutFault:
    return spot.put(spot.word.replace(spot["tag"], new), spot["name"])


def only(package: SourcePackage, pattern: str) -> Iterator[Spot]:
    """Yield the tag of a dependency, where it stands once and not in <export>, where nothing reads it."""
    found = list(package.spots(XML, pattern))
    for spot in found if len(found) == 1 else ():
        if "<export>" not in spot.text[: spot.match.start()]:
            yield spot


NOT_INSTALLED = "nothing installs Python code"
TAGGED = r"(<(?P<tag>{tag})>(?P<name>{name})</(?P=tag)>)"


@kind("manifest")
def exec_depend_of_what_is_compiled(package: SourcePackage) -> Iterator[PutFault]:
    found = package.words(CMAKE, r"^find_package\(\s*(\w+)") & package.words(SOURCES, r"^#include\s*[<\"](\w+)/")
    for name in sorted(found):
        for spot in only(package, TAGGED.format(tag="depend", name=name)):
            brought = brought_by(package.words(XML, r"<depend>([\w-]+)</depend>") - {name})
            yield changed_tag(spot, "exec_depend").known(name not in brought, "it comes with another dependency")


@kind("manifest")
def build_depend_of_what_is_imported(package: SourcePackage) -> Iterator[PutFault]:
    for name in sorted(package.words(OWN_PYTHON, r"^(?:from|import)\s+(\w+)")):
        for spot in only(package, TAGGED.format(tag="(?:exec_)?depend", name=name)):
            fault = spot.put(f"<build_depend>{name}</build_depend>", name)
            yield fault.known(is_installed(package), NOT_INSTALLED)


@kind("manifest")
def test_depend_of_what_is_imported(package: SourcePackage) -> Iterator[PutFault]:
    for name in sorted(package.words(OWN_PYTHON, r"^(?:from|import)\s+(\w+)")):
        for spot in only(package, TAGGED.format(tag="(?:exec_)?depend", name=name)):
            fault = spot.put(f"<test_depend>{name}</test_depend>", name)
            yield fault.known(is_installed(package), NOT_INSTALLED)


def is_installed(package: SourcePackage) -> bool:
    return package.is_python or package.holds(CMAKE, r"install\w*\(|auto_package")


@kind("manifest")
def test_depend_of_what_is_launched(package: SourcePackage) -> Iterator[PutFault]:
    for name in sorted(package.words(LAUNCH, r"(?:package|pkg)\s*=\s*['\"]([\w-]+)['\"]")):
        for spot in package.spots(XML, TAGGED.format(tag="exec_depend", name=name)):
            yield changed_tag(spot, "test_depend")
