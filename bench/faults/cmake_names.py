"""Faults of names in CMake: packages, targets, commands and variables."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bench.faults.cmake_stop import CMAKE, brought_by
from bench.faults.fault import PutFault
from bench.faults.kinds import kind
from bench.faults.known import INTERFACES
from bench.faults.source_package import SourcePackage

FAMILIES = ("rclcpp", "tf2", "pluginlib", "message_filters", "ament_", "nav2_", "moveit_", "image_", "pcl_")
"""What packages of ROS begin with whose variables ament writes."""


@kind("cmake")
def cmake_mistyped_sibling(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"find_package\(\s*(\w+)"):
        if spot.word in package.siblings:
            yield spot.typo()


@kind("cmake")
def cmake_mistyped_package(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"^find_package\(\s*(\w+_\w+)"):
        if spot.word not in package.siblings:
            yield spot.typo()


@kind("cmake")
def cmake_find_package_lost(package: SourcePackage) -> Iterator[PutFault]:
    linked = package.words(CMAKE, r"ament_target_dependencies\(\s*\$?\{?\w+\}?\s+(?:PUBLIC\s+)?(\w+)")
    linked |= package.words(CMAKE, r"\b(\w+)::\w+")
    found = package.words(CMAKE, r"^find_package\(\s*(\w+)")
    brought = brought_by(found)
    brought |= {name for each in found & package.siblings.keys() for name in handed_on(package, each)}
    for spot in package.spots(CMAKE, r"^find_package\(\s*(\w+)[^)]*\)[ \t]*\n"):
        if spot.word in linked - brought:
            yield spot.drop()


def handed_on(package: SourcePackage, sibling: str) -> list[str]:
    """Return what another package of the repository has CMake find for those that find it."""
    file = package.repository / package.siblings[sibling] / "CMakeLists.txt"
    text = file.read_text("utf-8", "replace") if file.is_file() else ""
    calls = re.findall(
        r"(?:ament_export_dependencies\(|rosidl_generate_interfaces\([^()]*DEPENDENCIES)([^()]*)\)", text
    )
    whole = re.findall(r"set\(([^()]*)\)", text) if any("$" in each for each in calls) else []
    return [word for each in (*calls, *whole) for word in each.split()]


@kind("cmake")
def cmake_mistyped_target_dependency(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(
        CMAKE, r"ament_target_dependencies\(\s*\$?\{?\w+\}?\s+(?:PUBLIC\s+)?[^()]*?\b([a-z]+_\w+)\b"
    ):
        yield spot.typo()


@kind("cmake")
def cmake_mistyped_imported_target(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"^\s+(?:PUBLIC |PRIVATE )?(\w+)::(\w{4,})\b", 2):
        is_known = spot.word == spot[1] or spot[1] in package.siblings
        yield spot.typo().known(is_known, "the targets of a package that is not here")


@kind("cmake")
def cmake_mistyped_linked_library(package: SourcePackage) -> Iterator[PutFault]:
    own = package.words(CMAKE, r"add_library\(\s*(\w+)")
    for spot in package.spots(CMAKE, r"target_link_libraries\(\s*\w+\s+(?:PUBLIC\s+|PRIVATE\s+)?(\w+)"):
        if spot.word in own:
            yield spot.typo()


@kind("cmake")
def cmake_mistyped_target(package: SourcePackage) -> Iterator[PutFault]:
    own = package.words(CMAKE, r"add_(?:library|executable)\(\s*(\w+)")
    pattern = r"(?:target_link_libraries|target_include_directories|ament_target_dependencies)\(\s*(\w+)"
    yield from (spot.typo() for spot in package.spots(CMAKE, pattern) if spot.word in own)


@kind("cmake")
def cmake_mistyped_command(package: SourcePackage) -> Iterator[PutFault]:
    commands = "target_include_directories|ament_target_dependencies|ament_package|rosidl_generate_interfaces"
    yield from (spot.typo() for spot in package.spots(CMAKE, rf"^[ \t]*({commands})\("))


@kind("cmake")
def cmake_unset_project_variable(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"DESTINATION\s+(?:share|lib)/\$\{(PROJECT_NAME)\}"):
        yield spot.put("PROJECTNAME")


@kind("cmake")
def cmake_mistyped_own_variable(package: SourcePackage) -> Iterator[PutFault]:
    for name in sorted(package.words(CMAKE, r"^\s*set\(\s*([A-Za-z]\w{4,})")):
        if not name.startswith(("CMAKE", "ament_")):
            yield from (spot.typo() for spot in package.spots(CMAKE, rf"^[^#\n]*(?<!ENV)\$\{{({name})\}}"))


@kind("cmake")
def cmake_variable_in_wrong_case(package: SourcePackage) -> Iterator[PutFault]:
    found = package.words(CMAKE, r"^find_package\(\s*([a-z]\w+)")
    for spot in package.spots(CMAKE, r"^(?!\s*message\().*?\$\{([a-z]\w+)_(?:INCLUDE_DIRS|LIBRARIES)\}"):
        if spot.word in found - {"catkin"}:
            fault = spot.put(spot.word.upper(), f"{spot.word}_INCLUDE_DIRS", f"{spot.word}_LIBRARIES")
            is_known = spot.word in {*package.siblings, *INTERFACES} or spot.word.startswith(FAMILIES)
            yield fault.known(is_known, "a module that finds a package which is not here may set it, too")
