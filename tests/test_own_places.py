"""DEP105, DEP115: what CMake fetches, or takes from a folder that people tell, need not come from rosdep."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

NODE = "add_executable(node src/node.cpp)\ninstall(TARGETS node DESTINATION lib/${PROJECT_NAME})\n"
LINKS = "target_link_libraries(node modbus)\n"
CPM = {"cmake/CPM.cmake": "function(CPMAddPackage)\nendfunction()\n"}


def levels(code: str, lines: str, source: str = "", depends: str = "", **files: str) -> list[str]:
    written = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{lines}\nament_package()"),
        "package.xml": manifest(depends, "ament_cmake"),
        "src/node.cpp": f"{source}\nint main() {{return 0;}}\n",
    }
    found = lint_files({**written, **CPM, **files}, [code]).findings
    return [each.severity.value for each in found]


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ("", ["warning"]),
        ('include(cmake/CPM.cmake)\nCPMAddPackage("gh:stephane/libmodbus#v3")\n', []),
        ("execute_process(COMMAND git clone https://x.org/libmodbus ${CMAKE_BINARY_DIR}/libmodbus)\n", []),
        ("execute_process(COMMAND pkg-config --cflags libmodbus)\n", ["warning"]),
        ("file(DOWNLOAD https://x.org/libmodbus.tgz ${CMAKE_BINARY_DIR}/libmodbus.tgz)\n", []),
        ("file(READ libmodbus.txt TEXT)\n", ["warning"]),
    ],
)
def test_what_cmake_fetches(lines: str, expected: list[str]) -> None:
    assert levels("DEP105", f"{lines}{NODE}", "#include <modbus/modbus.h>") == expected
    assert levels("DEP115", f"{lines}{NODE}{LINKS}") == expected


@pytest.mark.parametrize(
    ("folder", "expected"),
    [
        ("$ENV{MODBUS_ROOT}/include", "info"),
        ("${MODBUS_SDK_ROOT}/include", "info"),
        ("${MODBUS_INCLUDE_DIRS}", "warning"),
        ("/home/me/libmodbus/include", "info"),
        ("/usr/include/modbus", "warning"),
        ("third_party/libmodbus/src", "info"),
        ("third_party/serial/src", "warning"),
        ("include", "warning"),
    ],
)
def test_folders_of_headers(folder: str, expected: str) -> None:
    lines = f"{NODE}target_include_directories(node PRIVATE {folder})\n"
    assert levels("DEP105", lines, "#include <modbus/modbus.h>") == [expected]


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (f"{NODE}target_link_options(node PRIVATE -L/home/me/lib)\n{LINKS}", []),
        (f"{NODE}target_link_libraries(node -L/home/me/lib modbus)\n", []),
        (f'set(CMAKE_EXE_LINKER_FLAGS "-L/home/me/lib")\n{NODE}{LINKS}', []),
        (f'set(CMAKE_CXX_FLAGS "-O2")\n{NODE}{LINKS}', ["warning"]),
        (f"add_executable(node EXCLUDE_FROM_ALL src/node.cpp)\n{LINKS}", []),
    ],
)
def test_where_the_linker_looks(lines: str, expected: list[str]) -> None:
    assert levels("DEP115", lines) == expected


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("list(APPEND CMAKE_PREFIX_PATH /home/me/modbus)\n", []),
        ("set(CMAKE_LIBRARY_PATH /home/me/modbus)\n", []),
        ("set(CMAKE_PREFIX_PATH /usr/lib/modbus)\n", ["warning"]),
        ("", ["warning"]),
    ],
)
def test_where_cmake_looks(line: str, expected: list[str]) -> None:
    assert levels("DEP115", f"{line}find_library(MODBUS modbus REQUIRED)\n{NODE}") == expected


def test_a_key_without_headers_beside_a_build_from_source() -> None:
    lines = f"{NODE}target_link_libraries(node usb-1.0)\n"
    needs = "  <depend>libusb-1.0</depend>\n"
    assert levels("DEP115", lines, depends=needs) == ["warning"]
    page = {"README.md": "Build libusb-1.0 from source.\n"}
    assert levels("DEP115", lines, "", needs, **page) == ["info"]


@pytest.mark.parametrize(
    ("comment", "expected"),
    [
        ("# libmodbus has to be installed by hand", "info"),
        ("# build and install libmodbus from source first", "info"),
        ("# the program that speaks to libmodbus", "warning"),
        ("# install the scripts by hand", "warning"),
        ("# sudo apt install libmodbus-dev", "warning"),
    ],
)
def test_comments_of_cmake(comment: str, expected: str) -> None:
    lines = f"{comment}\n{NODE}"
    assert levels("DEP105", lines, "#include <modbus/modbus.h>") == [expected]
    assert levels("DEP115", f"{lines}{LINKS}") == [expected]


@pytest.mark.parametrize(
    ("page", "expected"),
    [
        ("sudo dpkg -i libmodbus_3.1_amd64.deb\n", "info"),
        ("wget https://acme.org/libmodbus5-3.1.deb\n", "info"),
        ("sudo apt install ./libmodbus-dev_3.1_arm64.deb\n", "info"),
        ("sudo dpkg -i arm_3.1_amd64.deb\n", "warning"),
        ("Install [libmodbus](https://github.com/stephane/libmodbus) first.\n", "info"),
        ("Install [libmodbus](https://github.com/stephane/libmodbus) by apt.\n", "warning"),
        ("It speaks to [libmodbus](https://github.com/stephane/libmodbus).\n", "warning"),
        ("Install [the arm](https://github.com/acme/arm) first.\n", "warning"),
    ],
)
def test_pages(page: str, expected: str) -> None:
    assert levels("DEP115", f"{NODE}{LINKS}", **{"README.md": page}) == [expected]
