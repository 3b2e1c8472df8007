"""Faults of sources in Python."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from bench.faults.fault import PutFault, Spot
from bench.faults.kinds import kind
from bench.faults.known import UNKNOWN, has_known_interfaces
from bench.faults.setup_py import parses
from bench.faults.source_package import SourcePackage

PYTHON = r"^(?!setup\.py|launch/|doc/|.*\.launch\.py).*\.py$"
ROS_1 = re.compile(r"^\s*(?:import|from) (?:rospy|roslib)\b", re.MULTILINE)


def spots(package: SourcePackage, pattern: str, group: int = 1) -> Iterator[Spot]:
    """Yield the places in files for ROS 2: one of ROS 1 ends at its first import, with a fault and without."""
    return (spot for spot in package.spots(PYTHON, pattern, group) if not ROS_1.search(spot.text))


@kind("python")
def python_mistyped_own_module(package: SourcePackage) -> Iterator[PutFault]:
    for spot in spots(package, rf"^from {package.name}\.(\w+)(?:\.\w+)* import"):
        if package.matching(rf"^(?:\w+/)?{package.name}/{spot.word}(\.py|/__init__\.py)$"):
            yield spot.typo()


@kind("python")
def python_mistyped_relative_module(package: SourcePackage) -> Iterator[PutFault]:
    for spot in spots(package, r"^from \.(\w+) import"):
        if package.matching(rf"/{spot.word}(\.py|/__init__\.py)$"):
            yield spot.typo()


@kind("python")
def python_mistyped_name_of_own_module(package: SourcePackage) -> Iterator[PutFault]:
    for spot in spots(package, rf"^from {package.name}\.(\w+) import (\w+)$", 2):
        if package.holds(rf"/{spot[1]}\.py$", rf"^(class|def) {spot.word}\b"):
            yield spot.typo()


@kind("python")
def python_own_module_renamed(package: SourcePackage) -> Iterator[PutFault]:
    for spot in spots(package, rf"^from {package.name}\.(\w+) import"):
        file = f"{package.name}/{spot.word}.py"
        if file in package.files:
            yield package.renamed(file, f"{package.name}/{spot.word}_2.py", spot.word)


@kind("python")
def python_sibling_as_top_level(package: SourcePackage) -> Iterator[PutFault]:
    if package.is_python:
        for spot in package.spots(rf"^{package.name}/\w+\.py$", rf"^from ({package.name}\.)(\w+) import"):
            if f"{package.name}/{spot[2]}.py" in package.files:
                yield spot.put("", spot[2])


@kind("python")
def python_mistyped_interface_module(package: SourcePackage) -> Iterator[PutFault]:
    for spot in spots(package, r"^from (\w+)\.(msg|srv|action) import (\w+)", 2):
        yield from in_use(package, [(spot, spot.put(f"{spot.word}s", f"{spot[1]}.{spot.word}s"))])


@kind("python")
def python_mistyped_interface(package: SourcePackage) -> Iterator[PutFault]:
    for spot in spots(package, r"^from (\w+)\.(?:msg|srv|action) import (\w+)", 2):
        fault = spot.typo().known(has_known_interfaces(package, spot[1]), UNKNOWN)
        yield from in_use(package, [(spot, fault)])


@kind("python")
def python_mistyped_interface_package(package: SourcePackage) -> Iterator[PutFault]:
    places = spots(package, r"^from (\w+)\.(?:msg|srv|action) import \w+")
    yield from in_use(package, ((spot, spot.typo()) for spot in places))


@kind("python")
def python_mistyped_field(package: SourcePackage) -> Iterator[PutFault]:
    for spot in spots(package, r"^\s+(\w*msg)\.(\w{4,})(?:\.\w+)*\s*=[^=]", 2):
        made = re.search(rf"\b{spot[1]}\s*=\s*([A-Z]\w+)\(\)", spot.text)
        if made is None:
            continue
        pattern = rf"^from (\w+)\.(?:msg|srv|action) import .*\b{made[1]}\b"
        source = re.search(pattern, spot.text, re.MULTILINE)
        yield spot.typo().known(source is not None and has_known_interfaces(package, source[1]), UNKNOWN)


@kind("python")
def python_undeclared_parameter(package: SourcePackage) -> Iterator[PutFault]:
    for spot in spots(package, r"self\.get_parameter\(\s*['\"]([\w.]+)['\"]"):
        if re.search(rf"declare_parameter\(\s*['\"]{re.escape(spot.word)}['\"]", spot.text):
            yield spot.typo()


@kind("python")
def python_mistyped_share(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in spots(package, r"get_package_share_directory\(\s*['\"](\w+)['\"]"))


@kind("python")
def python_main_renamed(package: SourcePackage) -> Iterator[PutFault]:
    registered = package.words(r"^setup\.py$", rf"{package.name}\.(\w+):main")
    for spot in package.spots(rf"^{package.name}/\w+\.py$", r"^def (main)\("):
        if spot.path.rpartition("/")[2].removesuffix(".py") in registered:
            star = re.search(r"^from (\w+)[\w.]* import \*", spot.text, re.MULTILINE)
            is_all_here = star is None or star[1] in package.siblings
            yield spot.put("run_node").known(is_all_here, "a module that is not here may have it: `import *`")


def in_use(package: SourcePackage, faults: Iterable[tuple[Spot, PutFault]]) -> Iterator[PutFault]:
    """Yield faults of syntax; of a file that nothing installs, imports or tests by its name, nobody is told."""
    for spot, fault in faults:
        name = spot.path.rpartition("/")[2]
        stem = re.escape(name.removesuffix(".py"))
        inside = spot.path.removeprefix(f"{package.folder}/") if package.folder else spot.path
        folder = re.escape(inside.partition("/")[0])
        named = package.holds(r"(^|/)(CMakeLists\.txt|setup\.py)$", rf"\b{stem}\b|DIRECTORY[^()]*\b{folder}\b")
        is_module = inside.startswith(f"{package.name}/") or f"/{package.name}/" in inside
        is_test = package.is_python and (name.startswith("test_") or name.endswith("_test.py"))
        imported = package.holds(r"\.py$", rf"^\s*(from|import) [\w., ]*\b{stem}\b")
        yield fault.known(named or is_module or is_test or imported, "nothing installs, imports or tests this file")


@kind("python")
def python_colon_lost(package: SourcePackage) -> Iterator[PutFault]:
    places = spots(package, r"^(?:def|class) \w+\([^\n]*\)(:)$")
    yield from in_use(package, ((spot, spot.of_file("")) for spot in places))


@kind("python")
def python_bracket_lost_at_return(package: SourcePackage) -> Iterator[PutFault]:
    places = spots(package, r"^\s+return [\w.]+\([^()\n]*(\))$")
    yield from in_use(package, ((spot, spot.of_file("")) for spot in places))


@kind("python")
def python_bracket_lost_beside_fstring(package: SourcePackage) -> Iterator[PutFault]:
    places = spots(package, r"^\s+[\w.]+\(f['\"][^\n]*['\"](\))$")
    yield from in_use(package, ((spot, spot.of_file("")) for spot in places))


@kind("python")
def python_import_of_ros_1(package: SourcePackage) -> Iterator[PutFault]:
    yield from parses(spot.put("rospy") for spot in spots(package, r"^import (rclpy)$"))


@kind("python")
def python_conflict_markers(package: SourcePackage) -> Iterator[PutFault]:
    places = spots(package, r"^(import \w+)\n")
    markers = "<<<<<<< HEAD\n{}\n=======\n>>>>>>> main"
    yield from in_use(package, ((spot, spot.of_file(markers.format(spot.word))) for spot in places))
