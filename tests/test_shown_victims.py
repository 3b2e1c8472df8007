"""Faults of CMake that somebody meets: a branch that is taken, a package that links, a class that is loaded."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

GONE = "add_executable(node src/gone.cpp)\n"
SWITCHED = "if({})\n  {}endif()\n"
USED = "add_executable(node src/node.cpp)\n"
NODE = {"src/node.cpp": '#include "my_pkg/nothing.hpp"\nint main() {return 0;}\n', "src/idle.cpp": ""}
OPTION = 'option(WITH_ARM "arm" {})\n'


def package(lines: str, **files: str) -> dict[str, str]:
    text = CMAKE.replace("ament_package", f"{lines}ament_package")
    return {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": text, **files}


def levels(files: dict[str, str], code: str) -> list[str]:
    return [each.severity.value for each in lint_files(files, [code]).findings]


@pytest.mark.parametrize(
    ("before", "condition", "page", "level"),
    [
        (OPTION.format("OFF"), "WITH_ARM", "", "info"),
        (OPTION.format(""), "WITH_ARM", "", "info"),
        (OPTION.format("OFF"), "${WITH_ARM} AND UNIX", "", "info"),
        (OPTION.format("ON"), "WITH_ARM", "", "warning"),
        (OPTION.format("OFF") + "set(WITH_ARM ${ARM})\n", "WITH_ARM", "", "warning"),
        (OPTION.format("OFF"), "NOT WITH_ARM", "", "warning"),
        (OPTION.format("OFF"), "WITH_ARM", "Build with `-DWITH_ARM=ON`.\n", "warning"),
        (OPTION.format("OFF"), "WITH_ARM OR ${ARM}", "", "warning"),
        ("", "BUILD_ARM", "", "info"),
        ("", "WIN32 AND BUILD_ARM", "", "info"),
        (OPTION.format("OFF"), "WITH_ARM", "`catkin_make -DWITH_ARM=ON`\n", "info"),
        (OPTION.format("OFF"), "WITH_ARM", "The arm is not ported yet (`WITH_ARM=OFF`).\n", "info"),
        (OPTION.format("OFF"), "WITH_ARM", "| `WITH_ARM` | OFF | build the arm |\n", "info"),
        (OPTION.format("OFF"), "WITH_ARM", "`WITH_ARM` is OFF by default, set it to ON for the arm.\n", "warning"),
        (OPTION.format("OFF"), "WITH_ARM", "Set `WITH_ARM` for the arm.\n", "warning"),
        (OPTION.format("OFF"), "WITH_ARM STREQUAL ON", "", "info"),
        (OPTION.format("OFF"), 'WITH_ARM STREQUAL "OFF"', "", "warning"),
        (OPTION.format("OFF") + "add_definitions(-DWITH_ARM)\n", "WITH_ARM", "", "info"),
        (OPTION.format("OFF") + "add_compile_definitions(WITH_ARM)\nset(HAS ${WITH_ARM})\n", "WITH_ARM", "", "info"),
        (OPTION.format("OFF") + "foreach(each WITH_ARM)\n  set(${each} ON)\nendforeach()\n", "WITH_ARM", "", "error"),
        (OPTION.format("OFF") + "if(${ALL})\n  set(WITH_ARM ON)\nendif()\n", "WITH_ARM", "", "warning"),
        ('option(CUDA "with CUDA" OFF)\n', "CUDA", "", "info"),
        ('set(CUDA OFF CACHE BOOL "with CUDA")\n', "CUDA", "", "info"),
        ("find_package(CUDA)\n", "CUDA", "", "warning"),
        ("set(CUDA_FOUND OFF)\nfind_package(CUDA)\n", "CUDA_FOUND", "", "warning"),
        ("find_package(ARM_SDK QUIET)\n", "ARM_SDK_FOUND", "", "warning"),
    ],
)
def test_a_branch_that_nobody_is_shown_to_take(before: str, condition: str, page: str, level: str) -> None:
    branch = SWITCHED.format(condition, GONE)
    assert levels(package(before + branch, **{"README.md": page, **NODE}), "CMK102") == [level]


@pytest.mark.parametrize(
    ("name", "text"), [("colcon.pkg", '["-DWITH_ARM=ON"]'), ("CMakePresets.json", '"WITH_ARM": true')]
)
def test_a_file_that_turns_a_switch_on(name: str, text: str) -> None:
    files = package(OPTION.format("OFF") + SWITCHED.format("WITH_ARM", GONE), **NODE)
    assert levels({**files, name: text}, "CMK102") == ["warning"]


def test_the_rest_of_a_condition_on_a_switch_that_is_off() -> None:
    other = OPTION.format("OFF") + "if(NOT WITH_ARM)\n  message(STATUS none)\nelse()\n  " + GONE + "endif()\n"
    assert levels(package(other, **NODE), "CMK102") == ["info"]


@pytest.mark.parametrize(("default", "level"), [("OFF", "info"), ("ON", "warning")])
@pytest.mark.parametrize(
    "command, path", [("add_subdirectory(arm)", "arm/CMakeLists.txt"), ("include(arm.cmake)", "arm.cmake")]
)
def test_a_file_that_is_read_by_a_switch(default: str, level: str, command: str, path: str) -> None:
    files = package(OPTION.format(default) + SWITCHED.format("WITH_ARM", f"{command}\n"), **NODE)
    assert levels({**files, path: GONE}, "CMK102") == [level]


@pytest.mark.parametrize(
    ("lines", "level"),
    [
        (USED, "error"),
        (OPTION.format("OFF") + SWITCHED.format("WITH_ARM", USED), "info"),
        (OPTION.format("ON") + SWITCHED.format("WITH_ARM", USED), "warning"),
        (USED.replace("node ", "node EXCLUDE_FROM_ALL "), "info"),
    ],
)
def test_a_header_of_what_nobody_asks_for(lines: str, level: str) -> None:
    assert levels(package(f"add_library(idle src/idle.cpp)\n{lines}", **NODE), "CMK201") == [level]


@pytest.mark.parametrize(
    ("lines", "level"),
    [
        ("include_directories(${CMAKE_SOURCEDIR}/include)\n", "info"),
        ("target_link_libraries(node ${CMAKE_SOURCEDIR}/libarm.so)\n", "info"),
        ("target_link_libraries(${PROJECTNAME} m)\n", "warning"),
        ('set(CMAKE_CXX_FLAGS "${CMAKE_CXXFLAGS} -O2")\n', "info"),
        ('set(CMAKE_CXX_FLAGS "-O2")\nset(CMAKE_CXX_FLAGS "${CMAKE_CXXFLAGS} -g")\n', "warning"),
        ("install(DIRECTORY src DESTINATION share/${PROJECTNAME})\n", "error"),
        ("set(HOME_OF_ALL ${CMAKE_SOURCEDIR}/a)\n", "info"),
        ("set(HOME_OF_ALL ${CMAKE_SOURCEDIR}/a)\ninstall(DIRECTORY ${HOME_OF_ALL} DESTINATION share)\n", "warning"),
    ],
)
def test_what_is_lost_with_a_variable(lines: str, level: str) -> None:
    assert levels(package(USED + lines, **{"src/node.cpp": "int main() {return 0;}\n"}), "CMK115") == [level]


TELL = "function({0})\n  {0}(STATUS hi)\nendfunction()\n"


@pytest.mark.parametrize(
    ("lines", "level"),
    [
        (TELL.format("message"), "error"),
        (TELL.format("ament_add_gtest"), "info"),
        (TELL.format("add_custom_target"), "info"),
        (TELL.format("add_custom_target") + "add_custom_target(all_of_it)\n", "error"),
    ],
)
def test_who_calls_a_redefined_command(lines: str, level: str) -> None:
    assert levels(package(lines), "CMK116") == [level]


PLUGIN = "#include <pluginlib/class_list_macros.hpp>\nPLUGINLIB_EXPORT_CLASS(my_pkg::Arm, my_base::Base)\n"
CLASSES = '<library path="arm"><class type="my_pkg::Arm" base_class_type="my_base::Base"/></library>\n'
LIBRARY = "add_library(idle SHARED src/idle.cpp)\npluginlib_export_plugin_description_file(my_base plugins.xml)\n"


@pytest.mark.parametrize(
    ("files", "level"),
    [({}, "info"), ({"config/arm.yaml": "arm:\n  ros__parameters:\n    plugin: my_pkg::Arm\n"}, "warning")],
)
def test_who_loads_a_class(files: dict[str, str], level: str) -> None:
    sources = {"src/idle.cpp": "", "src/arm.cpp": PLUGIN, "plugins.xml": CLASSES}
    assert levels(package(LIBRARY, **sources, **files), "CMK202") == [level]


def test_a_set_is_of_the_project_around_it() -> None:
    exported = "install(TARGETS core EXPORT arm_targets DESTINATION lib)\n"
    below = f"project(arm)\nadd_library(core SHARED core.cpp)\n{exported}"
    files = package("add_subdirectory(arm)\n", **{"arm/CMakeLists.txt": below, "arm/core.cpp": ""})
    (found,) = lint_files(files, ["CMK119"]).findings
    assert "`arm::core`" in found.message
    assert found.severity.value == "info"
