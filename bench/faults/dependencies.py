"""Faults of the dependencies in package.xml."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bench.faults.fault import PutFault
from bench.faults.kinds import kind
from bench.faults.source_package import SourcePackage

XML = r"^package\.xml$"
CMAKE = r"^CMakeLists\.txt$"
DEPEND = r"<(?:build_|exec_|test_|build_export_|buildtool_)?depend[^>]*>\s*([\w-]+)\s*</\w+>"
OWN_PYTHON = r"^(?!test/|tests/|setup\.py|launch/|.*\.launch\.py|doc|conf\.py|.*test_).*\.py$"
LAUNCH = r"(^|/)launch/.*\.(py|xml|yaml|launch)$|\.launch(\.py|\.xml)?$"
SOURCES = r"^(?!test/|tests/).*\.(cpp|hpp|h|cc)$"


def without(package: SourcePackage, name: str) -> PutFault | None:
    """Return the fault that every dependency on a name is lost, if the package has one."""
    pattern = rf"[ \t]*<(\w*depend)\b[^>]*>\s*({re.escape(name)})\s*</\1>[ \t]*\n?"
    found = list(package.spots(XML, pattern, 2))
    if not found or any("condition" in spot[0] for spot in found):
        return None
    text = found[0].text
    for spot in reversed(found):
        text = text[: spot.match.start()] + text[spot.match.end() :]
    return found[0].rewritten(text, name)


def lost(package: SourcePackage, names: set[str]) -> Iterator[PutFault]:
    for name in sorted(names - {package.name}):
        if (fault := without(package, name)) is not None:
            yield fault


@kind("manifest")
def depend_lost_that_cmake_finds(package: SourcePackage) -> Iterator[PutFault]:
    yield from lost(
        package,
        package.words(CMAKE, r"^find_package\(\s*(\w+)")
        - {"ament_cmake", "ament_cmake_python", "rosidl_default_generators"},
    )


@kind("manifest")
def depend_lost_that_is_imported(package: SourcePackage) -> Iterator[PutFault]:
    yield from lost(package, package.words(OWN_PYTHON, r"^(?:from|import)\s+(\w+)"))


@kind("manifest")
def depend_lost_that_tests_import(package: SourcePackage) -> Iterator[PutFault]:
    if not package.is_python:
        return
    own = package.words(r"^(?!tests?/).*\.py$", r"^(?:from|import)\s+(\w+)")
    yield from lost(package, package.words(r"^tests?/.*\.py$", r"^(?:from|import)\s+(\w+)") - own)


@kind("manifest")
def depend_lost_that_is_launched(package: SourcePackage) -> Iterator[PutFault]:
    yield from lost(package, package.words(LAUNCH, r"(?:package|pkg|\"package\")\s*[=:]\s*['\"]([\w-]+)['\"]"))


@kind("manifest")
def depend_lost_that_is_included(package: SourcePackage) -> Iterator[PutFault]:
    yield from lost(package, package.words(SOURCES, r"^#include\s*[<\"](\w+)/") & package.words(XML, DEPEND))


@kind("manifest")
def depend_lost_that_interfaces_use(package: SourcePackage) -> Iterator[PutFault]:
    yield from lost(package, package.words(r"\.(msg|srv|action)$", r"^([a-z]\w+)/\w+"))


@kind("manifest")
def depend_lost_that_urdf_uses(package: SourcePackage) -> Iterator[PutFault]:
    used = package.words(r"\.(xacro|urdf)$", r"(?:package://|\$\(find )([\w-]+)")
    built = "".join(package.text(file) for file in ("CMakeLists.txt", "setup.py"))
    folders = {file.partition("/")[0] for file in package.matching(r"\.(xacro|urdf)$")}
    is_installed = any(re.search(rf"\b{re.escape(each)}\b", built) for each in folders)
    for fault in lost(package, used):
        yield fault.known(is_installed, "nothing installs the description")


@kind("manifest")
def buildtool_lost(package: SourcePackage) -> Iterator[PutFault]:
    if package.holds(CMAKE, r"find_package\(\s*ament_cmake\b"):
        for spot in package.spots(XML, r"<buildtool_depend>(ament_cmake)</buildtool_depend>"):
            yield spot.drop_line()


@kind("manifest")
def generators_lost(package: SourcePackage) -> Iterator[PutFault]:
    if package.holds(CMAKE, r"rosidl_generate_interfaces\("):
        yield from lost(package, {"rosidl_default_generators"})


@kind("manifest")
def interface_runtime_lost(package: SourcePackage) -> Iterator[PutFault]:
    brings = r"<(?:exec_)?depend>rosidl_default_generators"
    if package.holds(CMAKE, r"rosidl_generate_interfaces\(") and not package.holds(XML, brings):
        yield from lost(package, {"rosidl_default_runtime"})


@kind("manifest")
def test_tool_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from lost(
        package,
        package.words(CMAKE, r"\bfind_package\(\s*(ament_cmake_(?:gtest|gmock|pytest)|launch_testing_ament_cmake)"),
    )


@kind("manifest")
def depend_mistyped_sibling(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in package.spots(XML, DEPEND) if spot.word in package.siblings)


@kind("manifest")
def depend_mistyped_package(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, DEPEND):
        if spot.word not in package.siblings and "-" not in spot.word and "_" in spot.word:
            yield spot.typo()


@kind("manifest")
def depend_mistyped_key(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in package.spots(XML, DEPEND) if "-" in spot.word)


@kind("manifest")
def depend_with_dash_sibling(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, DEPEND):
        if spot.word in package.siblings and "_" in spot.word:
            yield spot.put(spot.word.replace("_", "-"))


@kind("manifest")
def depend_with_dash_package(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, DEPEND):
        if spot.word not in {*package.siblings, "ament_python"} and "_" in spot.word and "-" not in spot.word:
            yield spot.put(spot.word.replace("_", "-"))


@kind("manifest")
def depend_of_ros_1(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<(?:exec_)?depend>(rclcpp|rclpy)</\w+>"):
        yield spot.put("roscpp" if spot.word == "rclcpp" else "rospy")


@kind("manifest")
def depend_by_module_name(package: SourcePackage) -> Iterator[PutFault]:
    modules = {"python3-yaml": "yaml", "python3-opencv": "cv2", "python3-numpy": "numpy", "python3-serial": "serial",
               "python3-pil": "PIL", "python3-scipy": "scipy", "python3-transforms3d": "transforms3d"}  # fmt: skip
    for spot in package.spots(XML, DEPEND):
        if spot.word in modules:
            yield spot.put(modules[spot.word])


@kind("manifest")
def depend_of_python_2(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(XML, r"<\w*depend>(python3-(?:numpy|yaml|opencv|serial|pytest|scipy|pil))</\w+>"):
        yield spot.put(spot.word.replace("python3-", "python-"))
