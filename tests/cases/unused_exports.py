"""Faults in what a package exports: a package here stops at it, or all here are libraries, or nobody meets it."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

NAMES = ("rclcpp", "std_msgs")
NEEDS = "".join(f"  <depend>{name}</depend>\n" for name in NAMES)
HEADER = "#include <rclcpp/rclcpp.hpp>\n#include <std_msgs/msg/string.hpp>\n"
FILES = {"src/core.cpp": '#include "my_pkg/core.hpp"\n', "include/my_pkg/core.hpp": HEADER}
LIBRARY = """\
find_package(rclcpp REQUIRED)
find_package(std_msgs REQUIRED)
add_library(core SHARED src/core.cpp)
ament_target_dependencies(core rclcpp std_msgs)
install(DIRECTORY include/ DESTINATION include)
install(TARGETS core DESTINATION lib)
ament_export_libraries(core)
"""
TELLS = "ament_export_include_directories(include)\n"
EXTRAS = 'ament_package(CONFIG_EXTRAS "core-extras.cmake")\n'
USER = manifest("  <depend>my_pkg</depend>\n", "ament_cmake").replace("<name>my_pkg", "<name>user")
USES = CMAKE.replace("my_pkg", "user").replace(
    "ament_package", "find_package(my_pkg REQUIRED)\nadd_executable(user a.cpp)\nament_package"
)
USERS = {"user/package.xml": USER, "user/CMakeLists.txt": USES, "user/a.cpp": "#include <my_pkg/core.hpp>\n"}

SET = """\
add_library(core SHARED src/core.cpp)
install(TARGETS core EXPORT core_targets DESTINATION lib)
"""
ONLY_HEADERS = SET.replace("SHARED src/core.cpp", "INTERFACE")
HEADERS = "install(DIRECTORY include/ DESTINATION include)\n"
BASE = "add_library(base {})\ninstall(TARGETS base EXPORT core_targets DESTINATION lib)\n"
NODES = FILES | {"src/core.cpp": "BT_REGISTER_NODES(factory) {}\n"}
DESCRIBED = FILES | {
    "plugins.xml": '<library path="core"><class type="my_pkg::Core" base_class_type="my_base::Base"/></library>\n'
}
DESCRIBES = "pluginlib_export_plugin_description_file(my_base plugins.xml)\n"


def package(lines: str, files: dict[str, str] = FILES) -> Example:
    text = CMAKE.replace("ament_package", lines + "ament_package")
    return Example(
        bad={"package.xml": manifest(NEEDS, "ament_cmake"), "CMakeLists.txt": text, **files}, good={}, on="ament_cmake"
    )


def beside_user(example: Example) -> Example:
    """A package beside one that is built with it."""
    return Example(
        bad={**{f"my_pkg/{path}": text for path, text in example.bad_files().items()}, **USERS}, good={}, on=""
    )


ROBOT = {
    "robot/package.xml": manifest("", "ament_cmake", "robot"),
    "robot/CMakeLists.txt": CMAKE.replace("my_pkg", "robot").replace(
        "ament_package", "add_executable(robot a.cpp)\ninstall(TARGETS robot DESTINATION lib/robot)\nament_package"
    ),
    "robot/a.cpp": "int main() {return 0;}\n",
}
CHANGES = {name: f"Changelog for package {name}\n====\n" for name in ("my_pkg", "robot")}
RELEASED = {
    "my_pkg/CHANGELOG.rst": CHANGES["my_pkg"],
    "robot/CHANGELOG.rst": CHANGES["robot"],
    "my_pkg/README.md": "Write `find_package(my_pkg REQUIRED)` and link it.\n",
}


def beside_robot(example: Example, more: dict[str, str] | None = None) -> Example:
    """A package beside one with a program that does not use it."""
    return Example(
        bad={**{f"my_pkg/{path}": text for path, text in example.bad_files().items()}, **ROBOT, **(more or {})},
        good={},
        on="",
    )


def with_needs(*names: str, includes: bool = True) -> Example:
    """A package that passes std_msgs on, beside one that is built with it and declares some more."""
    needs = "".join(f"  <depend>{name}</depend>\n" for name in ("my_pkg", *names))
    user = {"user/package.xml": manifest(needs, "ament_cmake").replace("<name>my_pkg", "<name>user")} | (
        {} if includes else {"user/a.cpp": ""}
    )
    example = beside_user(package(LIBRARY + TELLS + "ament_export_dependencies(rclcpp)\n"))
    return Example(bad={**example.bad, **user}, good={}, on="")


FAULTS = {
    "CMK106": SET + "ament_export_targets(core_targets)\n",
    "CMK113": LIBRARY + TELLS + "ament_export_dependencies(rclcpp)\n",
    "CMK117": LIBRARY + TELLS + "ament_export_dependencies(rclpcp std_msgs)\n",
    "CMK118": LIBRARY.replace("libraries(core)", "libraries(croe)"),
    "CMK119": SET + HEADERS,
    "CMK129": HEADERS.replace(")", ' FILES_MATCHING PATTERN "*.h")'),
}


def faulty(code: str) -> tuple[Example, ...]:
    """A fault in an export alone, beside a program, in a release of both, and beside one that uses the package."""
    example = package(FAULTS[code])
    return example, beside_robot(example), beside_robot(example, RELEASED), beside_user(example)


CASES = {
    **{code: faulty(code) for code in ("CMK106", "CMK117", "CMK118", "CMK129")},
    "CMK113": (
        *faulty("CMK113"),
        with_needs("std_msgs"),
        with_needs("sensor_msgs"),
        with_needs("strange_thing"),
        with_needs(includes=False),
        package(LIBRARY),
        package(LIBRARY + TELLS),
        package(LIBRARY + EXTRAS),
        package(LIBRARY + "team_export(core)\n"),
        beside_user(package(LIBRARY)),
        beside_user(package(LIBRARY + TELLS)),
    ),
    "CMK119": (
        *faulty("CMK119"),
        package(SET + HEADERS),
        package(SET),
        package(SET + "install(TARGETS core FILE_SET HEADERS)\n"),
        package(SET + BASE.format("INTERFACE")),
        package(SET + HEADERS, NODES),
        package(SET + HEADERS + "target_compile_definitions(core PRIVATE BT_PLUGIN_EXPORT)\n"),
        package(SET + HEADERS + DESCRIBES, DESCRIBED),
        package(SET + HEADERS, DESCRIBED),
        package(SET + HEADERS + DESCRIBES, DESCRIBED | {"plugins.xml": "<library></class>\n"}),
        package(SET + HEADERS + BASE.format("src/base.cpp"), NODES),
        beside_user(package(SET + HEADERS, NODES)),
        beside_user(package(SET)),
        beside_user(package(ONLY_HEADERS + HEADERS)),
        beside_user(package(ONLY_HEADERS + HEADERS + TELLS)),
    ),
}
