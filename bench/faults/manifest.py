"""Faults of package.xml that are not about one dependency."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bench.faults.fault import PutFault
from bench.faults.kinds import kind
from bench.faults.source_package import SourcePackage

XML = r"^package\.xml$"


@kind("manifest")
def manifest_without_build_type(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<build_type>\s*(ament_\w+)\s*</build_type>"):
        yield spot.drop_line("build_type", "package.xml")


@kind("manifest")
def manifest_other_build_type(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<build_type>\s*(ament_cmake|ament_python)\s*</build_type>"):
        yield spot.put("ament_python" if spot.word == "ament_cmake" else "ament_cmake")


@kind("manifest")
def manifest_second_build_type(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"(<build_type>\s*(ament_cmake|ament_python)\s*</build_type>)"):
        other = "ament_python" if spot[2] == "ament_cmake" else "ament_cmake"
        yield spot.put(f"{spot.word}\n    <build_type>{other}</build_type>", other, "build_type")


@kind("manifest")
def manifest_mistyped_build_type(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<build_type>\s*(ament_\w+)\s*</build_type>"):
        yield spot.typo()


@kind("manifest")
def manifest_short_version(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<version>\s*(\d+\.\d+\.\d+)\s*</version>"):
        yield spot.put(spot.word.rpartition(".")[0], "version")


@kind("manifest")
def manifest_version_with_v(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<version>\s*(\d+\.\d+\.\d+)\s*</version>"):
        yield spot.put(f"v{spot.word}", "version")


@kind("manifest")
def manifest_broken_email(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<maintainer[^>]*email=\"[^\"@]+(@)[^\"]+\""):
        yield spot.put(" at ", "email", "maintainer")


@kind("manifest")
def manifest_without_email(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<maintainer( email=\"[^\"]+\")"):
        yield spot.put("", "email", "maintainer")


@kind("manifest")
def manifest_without_maintainer(package: SourcePackage) -> Iterator[PutFault]:
    found = list(package.spots(XML, r"<(maintainer)[^>]*>[^<]*</maintainer>"))
    if len(found) == 1:
        yield found[0].drop_line()


@kind("manifest")
def manifest_without_license(package: SourcePackage) -> Iterator[PutFault]:
    found = list(package.spots(XML, r"<(license)[^>]*>[^<]*</license>"))
    if len(found) == 1:
        yield found[0].drop_line()


@kind("manifest")
def manifest_without_description(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<(description)>[^<]*</description>"):
        yield spot.drop()


@kind("manifest")
def manifest_unclosed_tag(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<(?:\w*depend|license|name)>[^<\n]+(</\w+>)"):
        yield spot.of_file("")


@kind("manifest")
def manifest_bare_ampersand(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<description>[^<&]*?\w( )\w"):
        yield spot.of_file(" & ")


@kind("manifest")
def manifest_mistyped_tag(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"(<(\w*depend)>([\w-]+)</\2>)"):
        wrong = spot[2].replace("depend", "dpeend")
        yield spot.put(f"<{wrong}>{spot[3]}</{wrong}>", wrong)


@kind("manifest")
def manifest_run_depend(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"(<exec_depend>([\w-]+)</exec_depend>)"):
        yield spot.put(f"<run_depend>{spot[2]}</run_depend>", "run_depend")


@kind("manifest")
def manifest_exec_dependency(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"(<exec_depend>([\w-]+)</exec_depend>)"):
        yield spot.put(f"<exec_dependency>{spot[2]}</exec_dependency>", "exec_dependency")


@kind("manifest")
def manifest_format_one(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<package format=\"([23])\""):
        newer = r"<(?:(?:exec_|build_export_|buildtool_export_|doc_)?depend|group_depend|member_of_group)\b|condition="
        if package.holds(XML, newer):  # else each tag is one of format 1, too
            yield spot.put("1", "format")


@kind("manifest")
def manifest_broken_condition(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<depend()>[\w-]+</depend>"):
        yield spot.put(' condition="$ROS_VERSION = 2"', "condition", "$ROS_VERSION = 2")


@kind("manifest")
def manifest_mistyped_own_name(package: SourcePackage) -> Iterator[PutFault]:
    if package.holds(r"^(setup\.py|CMakeLists\.txt)$", rf"\b{re.escape(package.name)}\b"):
        for spot in package.spots(XML, r"<name>\s*([\w-]+)\s*</name>"):
            yield spot.typo()


@kind("manifest")
def manifest_dash_in_own_name(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<name>\s*(\w+_\w+)\s*</name>"):
        yield spot.put(spot.word.replace("_", "-"))


@kind("manifest")
def manifest_capital_in_own_name(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<name>\s*([a-z]\w+)\s*</name>"):
        yield spot.put(spot.word.capitalize())


@kind("manifest")
def manifest_name_of_a_sibling(package: SourcePackage) -> Iterator[PutFault]:
    others = sorted(set(package.siblings) - {package.name})
    for spot in package.spots(XML, r"<name>\s*([\w-]+)\s*</name>"):
        if others:
            yield spot.put(others[len(package.name) % len(others)])


@kind("manifest")
def manifest_conflict_markers(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"^(\s*<exec_depend>[\w-]+</exec_depend>)\n"):
        yield spot.of_file(f"<<<<<<< HEAD\n{spot.word}\n=======\n>>>>>>> main")


@kind("manifest")
def manifest_without_interface_group(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<(member_of_group)>\s*rosidl_interface_packages\s*</member_of_group>"):
        yield spot.drop_line("rosidl_interface_packages")


@kind("manifest")
def manifest_exported_file_mistyped(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"^(?!.*condition=).*plugin=\"\$\{prefix\}/([\w/.]+\.xml)\""):
        yield spot.typo(spot.word.rpartition("/")[2])
