"""Libraries that a project builds and installs by itself: the key of rosdep is not what its build takes."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.depends.hand_installs import HandInstalls
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.files import PackageFiles
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import MemoryTree

NODE = "add_executable(node src/node.cpp)\n"
SERIAL = "#include <libserialport.h>\n"


def told(lines: str, source: str = SERIAL, **files: str) -> list[tuple[str, str, str]]:
    written = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{NODE}{lines}\nament_package()"),
        "package.xml": manifest("", "ament_cmake"),
        "src/node.cpp": f"{source}int main() {{return 0;}}\n",
    }
    found = lint_files({**written, **files}, ["DEP104", "DEP105", "DEP115"]).findings
    return [(each.code, each.severity.value, each.message.rpartition("; ")[2]) for each in found]


@pytest.mark.parametrize(
    ("lines", "place"),
    [
        ("target_link_libraries(node /usr/local/lib/libserialport.so)", "/usr/local/lib/libserialport.so"),
        ("target_link_libraries(node /usr/local/lib/libserialport.so.0.1)", "/usr/local/lib/libserialport.so.0.1"),
        ("set(LIB /opt/libserialport)\ninclude_directories(${LIB}/include)", "/opt/libserialport"),
        ("target_link_libraries(node -L/opt/serialport/lib)", "/opt/serialport/lib"),
    ],
)
def test_a_library_that_cmake_takes_from_beside_apt_is_an_info(lines: str, place: str) -> None:
    assert told(lines) == [("DEP105", "info", f"CMake takes it from `{place}`, where the key does not put it")]


@pytest.mark.parametrize(
    "lines",
    [
        "",
        "target_link_libraries(node /usr/local/lib/libsbp.a)",
        "include_directories(/usr/local/include)",
        "include_directories(/usr/local/include/libserialport)",
        "find_path(SERIAL libserialport.h PATHS /opt/libserialport)",
        "target_link_libraries(node /usr/lib/x86_64-linux-gnu/libserialport.so)",
        "include_directories(/opt/ros/humble/include/libserialport)",
    ],
)
def test_what_cmake_takes_from_there_of_others_changes_nothing(lines: str) -> None:
    assert ("DEP105", "warning", "add <depend>libserialport-dev</depend>") in told(lines)


def test_the_same_of_packages_that_cmake_finds() -> None:
    lines = "set(CMAKE_PREFIX_PATH /opt/yaml-cpp)\nfind_package(yaml-cpp REQUIRED)"
    assert [each[:2] for each in told(lines, "")] == [("DEP104", "info")]


CLONE = "git clone https://github.com/a/libserialport.git\ncd libserialport\n./configure\nmake\nsudo make install\n"


@pytest.mark.parametrize(
    ("path", "text", "level"),
    [
        ("sdk/sdk-install", f"#!/usr/bin/env bash\n{CLONE}", "info"),
        ("sdk/sdk-install", f"#!/bin/sh\n{CLONE}", "info"),
        ("sdk/notes", CLONE, "warning"),
        (".github/workflows/ci.yml", f"      run: |\n        {CLONE}", "info"),
    ],
)
def test_a_script_without_a_suffix_installs_by_hand_too(path: str, text: str, level: str) -> None:
    assert [each[:2] for each in told("", **{path: text})] == [("DEP105", level)]


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("pushd lcm && make && sudo make install", {"lcm"}),
        ("WORKDIR /tmp/lcm\nRUN cmake . && make install", {"lcm"}),
        ("cd lcm-*\n./configure && make install", {"lcm"}),
        ('cd "$HOME/lcm"\nmake install', {"lcm"}),
        ("sudo make -C deps/lcm install", {"lcm"}),
        ("cmake -S lcm -B build\ncmake --build build\nsudo cmake --install build", {"lcm"}),
        ("wget https://example.org/lcm-1.4.0.tar.gz\ntar xf *.gz\ncd $X && ./configure && make install", {"lcm"}),
        ("make -C firmware all", set()),
        ("wget https://example.org/lcm-1.4.0.tar.gz\n", set()),
    ],
)
def test_ways_to_make_and_install(text: str, names: set[str]) -> None:
    files = PackageFiles(MemoryTree.of({"install.sh": text}))
    assert HandInstalls(files).named >= names
    assert bool(HandInstalls(files).named & {"lcm", "firmware"}) == bool(names)
