"""Faults at which CMake or the compiler stops."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from bench.faults.fault import PutFault
from bench.faults.kinds import kind
from bench.faults.source_package import SourcePackage
from rospkg_cli.ros.read_table import rows

CMAKE = r"^CMakeLists\.txt$"
BROUGHT = {
    "rclcpp": "ament_index_cpp builtin_interfaces rcl rcl_interfaces rcpputils rcutils rmw rosgraph_msgs tracetools",
    "rclcpp_lifecycle": "rclcpp lifecycle_msgs rcl_lifecycle",
    "rclcpp_action": "rclcpp action_msgs rcl_action",
    "rclcpp_components": "rclcpp class_loader ament_index_cpp composition_interfaces",
    "geometry_msgs": "std_msgs builtin_interfaces",
    "sensor_msgs": "geometry_msgs std_msgs builtin_interfaces",
    "nav_msgs": "geometry_msgs std_msgs builtin_interfaces",
    "tf2_ros": "rclcpp rclcpp_action rclcpp_components rcl_interfaces tf2 tf2_msgs geometry_msgs message_filters",
    "tf2_geometry_msgs": "tf2 tf2_ros geometry_msgs orocos_kdl_vendor",
    "controller_interface": "hardware_interface rclcpp_lifecycle realtime_tools",
    "controller_manager": "controller_interface hardware_interface pluginlib rclcpp realtime_tools",
    "hardware_interface": "pluginlib rclcpp rclcpp_lifecycle control_msgs lifecycle_msgs rcpputils",
}
"""What CMake finds along with a package: leaving out their own find_package is no fault."""


def brought_by(names: Iterable[str]) -> set[str]:
    """Return what CMake finds along with some packages, and with those that they export."""
    exported, found, waiting = rows("exported_dependencies.txt"), set[str](), list(names)
    while waiting:
        name = waiting.pop()
        more = {*BROUGHT.get(name, "").split(), *exported.get(name, ())} - found
        found |= more
        waiting += more
    return found


@kind("cmake")
def cmake_mistyped_source(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"add_(?:executable|library)\([^()]*?\b([\w]+\.c(?:pp|c|xx)?)\b"):
        if package.matching(rf"(^|/){spot.word}$"):
            yield spot.typo()


@kind("cmake")
def cmake_mistyped_test_source(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"ament_add_(?:gtest|gmock|pytest_test)\([^()]*?\b(\w+\.(?:cpp|py))\b"):
        if package.matching(rf"(^|/){spot.word}$"):
            yield spot.typo()


@kind("cmake")
def cmake_mistyped_launch_test(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"add_launch_test\(\s*\"?([\w./]+\.py)"):
        yield spot.typo(spot.word.rpartition("/")[2])


@kind("cmake")
def cmake_without_ament(package: SourcePackage) -> Iterator[PutFault]:
    if len(list(package.spots(CMAKE, r"find_package\(\s*ament_cmake\w*", 0))) < 3:
        for spot in package.spots(CMAKE, r"^find_package\(\s*(ament_cmake)\b[^)]*\)[ \t]*\n"):
            yield spot.drop()


@kind("cmake")
def cmake_executable_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"^add_executable\(\s*(\w+)[^()]*\)[ \t]*\n"):
        if package.holds(CMAKE, rf"install\(\s*TARGETS[^()]*\b{spot.word}\b"):
            yield spot.drop()


@kind("cmake")
def cmake_parenthesis_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in package.spots(CMAKE, r"^find_package\([^()\n]*(\))"))


@kind("cmake")
def cmake_endif_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.drop("CMakeLists.txt") for spot in package.spots(CMAKE, r"^(endif)\([^)]*\)\n"))


@kind("cmake")
def cmake_quote_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in package.spots(CMAKE, r"\"[^\"\n]*\w(\")"))


@kind("cmake")
def cmake_other_project(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"^project\(\s*(\w+)"):
        if spot.word == package.name and package.holds(CMAKE, r"^\s*find_package\(\s*ament"):
            yield spot.put("my_package")


@kind("cmake")
def cmake_without_project(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.drop("CMakeLists.txt") for spot in package.spots(CMAKE, r"^(project)\([^)]*\)\n"))


@kind("cmake")
def cmake_mistyped_subdirectory(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in package.spots(CMAKE, r"(?<!\w)add_subdirectory\(\s*([\w/]+)\s*\)"))


@kind("cmake")
def cmake_gtest_not_found(package: SourcePackage) -> Iterator[PutFault]:
    for tool in ("gtest", "gmock", "pytest"):
        if package.holds(CMAKE, rf"ament_add_{tool}(_test)?\(") and not package.holds(
            CMAKE, "ament_lint_auto|ament_cmake_auto|ament_cmake_ros"
        ):  # the last one finds all three for whoever finds it
            yield from (
                spot.drop() for spot in package.spots(CMAKE, rf"^\s*find_package\(\s*(ament_cmake_{tool})\b[^)]*\)\n")
            )


@kind("cmake")
def cmake_mistyped_parameter_library(package: SourcePackage) -> Iterator[PutFault]:
    pattern = r"generate_parameter_(?:library|module)\([^()]*?([\w/]+\.ya?ml)"
    yield from (spot.typo(spot.word.rpartition("/")[2]) for spot in package.spots(CMAKE, pattern))


@kind("cmake")
def cmake_mistyped_interface(package: SourcePackage) -> Iterator[PutFault]:
    pattern = r"^\s*\"?((?:msg|srv|action)/\w+\.(?:msg|srv|action))\"?"
    for spot in package.spots(CMAKE, pattern):
        yield spot.typo(spot.word.rpartition("/")[2])


@kind("cmake")
def cmake_conflict_markers(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"^(find_package\([^)]*\))\n"):
        yield spot.of_file(f"<<<<<<< HEAD\n{spot.word}\n=======\n>>>>>>> main")


@kind("cmake")
def cmake_mistyped_keyword(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots(CMAKE, r"install\(\s*\w+\s+([^()]*?)\b(DESTINATION)\b", 2):
        yield spot.put("DESTINTION", *(word.strip("/") for word in spot[1].split()[:5]))


@kind("cmake")
def cmake_find_of_ros_1(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("roscpp") for spot in package.spots(CMAKE, r"^find_package\(\s*(rclcpp)\b"))
