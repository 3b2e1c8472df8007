"""Headers of libraries that a submodule brings, or that are included only where CMake happens to find them (DEP105)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

MODULE = '[submodule "lib"]\n\tpath = {}\n\turl = {}\n'
JSON = ("<nlohmann/json.hpp>", "<cxxopts.hpp>")


def levels(include: str, lines: str, **files: str) -> list[str]:
    written = {
        "ws/pkg/package.xml": manifest("", "ament_cmake"),
        "ws/pkg/CMakeLists.txt": CMAKE.replace("ament_package()", f"{lines}\nament_package()"),
        "ws/pkg/src/node.cpp": f"#include {include}\nint main() {{return 0;}}\n",
    }
    return [each.severity.value for each in lint_files({**written, **files}, ["DEP105"]).findings]


@pytest.mark.parametrize(
    ("include", "path", "url", "line", "expected"),
    [
        ("<cxxopts.hpp>", "ws/pkg/external/cxxopts", "https://github.com/jarro2783/cxxopts", "", []),
        ("<cxxopts.hpp>", "ws/other/external/opts", "git@github.com:jarro2783/cxxopts.git", "", []),
        ("<nlohmann/json.hpp>", "ws/pkg/external/j", "https://github.com/nlohmann/json/", "", []),
        ("<cxxopts.hpp>", "ws/pkg/external/opts", "https://x.org/a/words", "", ["warning"]),
        ("<cxxopts.hpp>", "cxxopts/ws/words", "https://cxxopts.org/a/words", "", ["warning"]),
        ("<cxxopts.hpp>", "ws/pkg/lib", "https://x.org/a/b", "include_directories(lib/include)", ["info"]),
        ("<cxxopts.hpp>", "ws/pkg/lib", "https://x.org/a/b", "add_subdirectory(lib)", ["info"]),
        ("<cxxopts.hpp>", "ws/pkg/lib", "https://x.org/a/b", "include_directories(include)", ["warning"]),
        ("<cv_bridge/cv_bridge.h>", "ws/pkg/lib", "https://x.org/a/b", "add_subdirectory(lib)", ["warning"]),
    ],
)
def test_what_a_submodule_brings(include: str, path: str, url: str, line: str, expected: list[str]) -> None:
    lines = f"{line}\nadd_executable(node src/node.cpp)"
    assert levels(include, lines, **{".gitmodules": MODULE.format(path, url)}) == expected


TOOL = "  add_executable(node src/node.cpp)\n"
QUIET = "find_package(Boost QUIET COMPONENTS program_options)\n"


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (f"{QUIET}if(Boost_FOUND)\n{TOOL}endif()", []),
        (f"{QUIET}if(Boost_PROGRAM_OPTIONS_FOUND)\n{TOOL}endif()", []),
        (f"if(BUILD_TESTING)\n{QUIET}if(Boost_PROGRAM_OPTIONS_FOUND)\n{TOOL}endif()\nendif()", []),
        (f"option(BUILD_TESTING ON)\n{QUIET}{TOOL}", ["warning"]),
        (f"{QUIET}{TOOL}", ["warning"]),
        (f"if(BUILD_TESTING)\n{TOOL}endif()", ["warning"]),
        (f'option(BUILD_TESTING "Tests" ON)\nif(BUILD_TESTING)\n{TOOL}endif()', ["warning"]),
        (f'option(BUILD_TESTING "Tests" OFF)\nif(BUILD_TESTING)\n{TOOL}endif()', ["info"]),
        (f'option(WITH_TESTS "Tests" OFF)\nif(BUILD_TESTING AND WITH_TESTS)\n{TOOL}endif()', ["info"]),
    ],
)
def test_what_is_built_only_where_it_is_found_or_asked_for(lines: str, expected: list[str]) -> None:
    assert levels("<boost/program_options.hpp>", lines) == expected


def test_what_a_dependency_brings_serves_without_headers_of_its_own() -> None:
    """`pcl_conversions` brings libboost-system, and with it all that libpcl-dev is built with."""
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", "find_package(Boost REQUIRED system)\nament_package()"),
        "package.xml": manifest("  <depend>pcl_conversions</depend>\n", "ament_cmake"),
    }
    assert [each.severity.value for each in lint_files(files, ["DEP104"]).findings] == ["info"]


@pytest.mark.parametrize("name", ["pcl_conversions", "pcl_ros", "libpcl-all-dev", "libvtk9-dev", "boost", "rclcpp"])
def test_what_brings_mpi_under_a_name_without_a_key(name: str) -> None:
    """libvtk9-dev needs HDF5 for MPI, and Boost its own part for it: both install libopenmpi-dev."""
    files = {
        "CMakeLists.txt": CMAKE.replace(
            "ament_package()", "find_package(MPI REQUIRED COMPONENTS CXX)\nament_package()"
        ),
        "package.xml": manifest(f"  <depend>{name}</depend>\n", "ament_cmake"),
    }
    told = {each.severity.value for each in lint_files(files, ["DEP104"]).findings}
    assert told == {"warning"} if name == "rclcpp" else "warning" not in told


@pytest.mark.parametrize(("name", "level"), [("pcl_conversions", "info"), ("pcl_ros", "info"), ("rclcpp", "warning")])
def test_what_the_headers_of_pcl_bring_from_humble_on(name: str, level: str) -> None:
    lines = "find_package(PkgConfig REQUIRED)\npkg_check_modules(PROJ REQUIRED proj)\n"
    files = {
        "package.xml": manifest(f"  <depend>pkg-config</depend>\n  <depend>{name}</depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}ament_package"),
    }
    (finding,) = lint_files(files, ["DEP115"]).findings
    assert finding.severity.value == level


def test_cppzmq_comes_with_the_headers_of_zeromq() -> None:
    """libzmqpp-dev is another binding; libzmq3-dev recommends cppzmq-dev, which has no key of its own."""
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", "find_package(cppzmq REQUIRED)\nament_package()"),
        "package.xml": manifest("", "ament_cmake"),
    }
    (finding,) = lint_files(files, ["DEP104"]).findings
    assert "add <depend>libzmq3-dev</depend>" in finding.message
