"""What a build leaves out: libraries without an export, programs without a suffix, headers of a key (CMK119, …)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

LIBRARY = """\
add_library(core SHARED src/core.cpp)
target_include_directories(core PUBLIC include/my_pkg)
install(TARGETS core DESTINATION lib)
install(DIRECTORY include/ DESTINATION include)
"""
CORE = {"src/core.cpp": '#include "core.h"\nint core() {return 1;}\n', "include/my_pkg/core.h": "int core();\n"}
SCRIPT = "#!/usr/bin/env python3\nimport rclpy\n\n\nif __name__ == '__main__':\n    rclpy.init()\n"
AUTO = "find_package(ament_cmake_auto REQUIRED)\nament_auto_add_executable(talker src/talker.cpp)\n"
MAIN = {"src/talker.cpp": "int main() {return 0;}\n"}


def told(code: str, lines: str, files: dict[str, str], depends: str = "", end: str = "ament_package()") -> list[str]:
    given = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{lines}{end}"),
        "package.xml": manifest(depends, "ament_cmake"),
        **files,
    }
    return [each.message for each in lint_files(given, [code]).findings if each.code == code]


@pytest.mark.parametrize(
    "lines, files, count",
    [
        (LIBRARY, CORE, 1),
        (LIBRARY, {**CORE, "src/core.cpp": '#include "my_pkg/core.h"\nint core() {return 1;}\n'}, 1),
        (LIBRARY, {**CORE, "src/core.h": "int core();\n"}, 0),  # which may be the one that is included
        (LIBRARY, {**CORE, "src/core.cpp": '#include "ore.h"\nint core() {return 1;}\n'}, 0),
        (LIBRARY + "ament_export_libraries(core)\n", CORE, 0),
        (LIBRARY, {**CORE, "cmake/my_pkg.pc.in": "Libs: -lcore\n"}, 0),
    ],
)
def test_libraries_that_nothing_exports(lines: str, files: dict[str, str], count: int) -> None:
    assert len(told("CMK119", lines, files)) == count


@pytest.mark.parametrize(
    "path, text, count",
    [
        ("scripts/listen", SCRIPT, 1),
        ("scripts/listen.py", SCRIPT, 1),
        ("scripts/listen", SCRIPT.replace("rclpy", "yaml"), 0),
        ("scripts/listen", SCRIPT.replace("rclpy", "rospy"), 0),
        ("scripts/listen", "#!/bin/sh\nros2 topic list\n", 0),
        ("scripts/listen.txt", SCRIPT, 0),
        ("tools/listen", SCRIPT, 0),
    ],
)
def test_programs_of_which_none_is_installed(path: str, text: str, count: int) -> None:
    depends = "  <buildtool_depend>ament_cmake_auto</buildtool_depend>\n  <exec_depend>rclpy</exec_depend>\n"
    assert len(told("CMK112", AUTO, {**MAIN, path: text}, depends, "ament_auto_package()")) == count


@pytest.mark.parametrize(
    "depends, text",
    [
        ("  <depend>protobuf</depend>\n", "declares `protobuf` alone, which has no headers"),
        ("  <depend>protobuf-dev</depend>\n", ""),
        ("  <depend>protobuf</depend>\n  <build_depend>protobuf-dev</build_depend>\n", ""),
    ],
)
def test_a_key_without_headers(depends: str, text: str) -> None:
    messages = told("DEP104", "find_package(Protobuf REQUIRED)\n", {}, depends)
    assert len(messages) == bool(text)
    assert all(text in each for each in messages)


@pytest.mark.parametrize(
    "tool, lines, count",
    [
        ("ament_cmake_core", "find_package(ament_cmake REQUIRED)\n", 1),
        ("ament_cmake_python", "find_package(ament_cmake REQUIRED)\nfind_package(ament_cmake_python REQUIRED)\n", 1),
        ("ament_cmake_core", "find_package(ament_cmake_core REQUIRED)\n", 0),
        ("ament_cmake_ros", "find_package(ament_cmake REQUIRED)\n", 0),
        ("ament_cmake_auto", "find_package(ament_cmake REQUIRED)\n", 0),
        ("autoware_cmake", "find_package(ament_cmake REQUIRED)\n", 0),
        ("acme_cmake", "find_package(ament_cmake REQUIRED)\n", 0),
    ],
)
def test_parts_of_the_build_tool(tool: str, lines: str, count: int) -> None:
    package = manifest("", "ament_cmake").replace("depend>ament_cmake<", f"depend>{tool}<")
    cmake = CMAKE.replace("find_package(ament_cmake REQUIRED)\n", lines)
    messages = told("XML208", "", {"package.xml": package, "CMakeLists.txt": cmake})
    assert len(messages) == count
    assert all("does not declare `ament_cmake`" in each for each in messages)


LINKED = "add_library(core SHARED src/core.cpp)\ntarget_link_libraries(core PRIVATE usb-1.0)\n"
USB = {"src/core.cpp": "int core() {return 1;}\n"}
INCLUDED = {"src/core.cpp": "#include <libusb.h>\nint core() {return 1;}\n"}
ALONE = "add_library(core SHARED src/core.cpp)\n"


@pytest.mark.parametrize(
    "lines, files, depends, count",
    [
        (LINKED, USB, "  <depend>libusb-1.0</depend>\n", 1),
        (ALONE, INCLUDED, "  <depend>libusb-1.0</depend>\n", 1),
        (LINKED, INCLUDED, "  <exec_depend>libusb-1.0</exec_depend>\n", 1),
        (LINKED, INCLUDED, "  <depend>libusb-1.0-dev</depend>\n", 0),
        (LINKED, USB, "  <build_depend>libusb-1.0-dev</build_depend>\n  <exec_depend>libusb-1.0</exec_depend>\n", 0),
        (LINKED, USB, "  <depend>libusb-1.0</depend>\n  <depend>acme_usb</depend>\n", 0),  # which may bring it
        (LINKED, USB, "  <depend>libusb-1.0</depend>\n  <depend>libusb-dev</depend>\n", 0),
        (ALONE, USB, "  <depend>libusb-1.0</depend>\n", 0),
        (ALONE, {"src/core.cpp": "#if USB\n#include <libusb.h>\n#endif\n"}, "  <depend>libusb-1.0</depend>\n", 0),
        (ALONE, {**INCLUDED, "include/libusb.h": "int usb();\n"}, "  <depend>libusb-1.0</depend>\n", 0),
        ("if(USB)\n  find_library(USB usb-1.0 REQUIRED)\nendif()\n", USB, "  <depend>libusb-1.0</depend>\n", 0),
        (ALONE, {"src/core.cpp": "#include <X11/Xlib.h>\n"}, "  <depend>libx11</depend>\n", 0),
    ],
)
def test_keys_without_headers(lines: str, files: dict[str, str], depends: str, count: int) -> None:
    messages = told("DEP115", lines, files, depends)
    assert len(messages) == count
    assert all(each.startswith("`libusb-1.0` has neither headers") for each in messages)
