"""C++ files that no build reads: below a CMakeLists.txt that nothing adds, or headers that no source includes."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

TARGET = "add_library(words SHARED src/words.cpp)\ntarget_include_directories(words PUBLIC include)\n"
INSTALL = "install(DIRECTORY include/ DESTINATION include)\n"
WRONG = '#include "my_pkg/wodrs.hpp"\n'
UNKNOWN = "target_sources(words PRIVATE ${MORE})\nadd_executable(other ${SOURCES_OF_OTHERS})\n"
TESTS = {"extra/CMakeLists.txt": "add_executable(extra words.cpp)\n", "extra/words.cpp": f"{WRONG}int main() {{}}\n"}


def told(lines: str, code: str = "CMK201", **more: str) -> list[tuple[str, str]]:
    """Return path and level of each finding; paths have `__` for a slash and `_DOT_` for a dot."""
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{TARGET}{INSTALL}{lines}ament_package"),
        "include/my_pkg/words.hpp": "int words();\n",
        "src/words.cpp": '#include "my_pkg/words.hpp"\nint words() {return 0;}\n',
        **{path.replace("__", "/").replace("_DOT_", "."): text for path, text in more.items()},
    }
    return [(each.location.path, each.severity.value) for each in lint_files(files, [code]).findings]


@pytest.mark.parametrize(
    "lines, level",
    [
        (UNKNOWN, "info"),
        (UNKNOWN + "# add_subdirectory(extra)\n", "info"),
        (UNKNOWN + "if(ANYTHING)\n  add_subdirectory(extra)\nendif()\n", "warning"),
        (UNKNOWN + "foreach(each extra)\n  add_subdirectory(${each})\nendforeach()\n", "warning"),
        (UNKNOWN + "message(FATAL_ERROR stop)\nadd_subdirectory(extra)\n", "warning"),
        (UNKNOWN + "message(FATAL_ERROR stop)\n", "info"),
        (UNKNOWN + "add_executable(more extra/words.cpp)\n", "warning"),
    ],
)
def test_a_folder_that_nothing_adds(lines: str, level: str) -> None:
    assert told(lines, **TESTS) == [("extra/words.cpp", level)]


@pytest.mark.parametrize(
    "page, level",
    [
        ("Run `cmake -S extra -B build`.\n", "warning"),
        ("cd my_pkg/extra && cmake .\n", "warning"),
        ("cd extra_parts && cmake .\n", "info"),
        ("The folder `extra` has more.\n", "info"),
    ],
)
def test_a_folder_that_a_page_builds(page: str, level: str) -> None:
    assert told(UNKNOWN, README_DOT_md=page, **TESTS) == [("extra/words.cpp", level)]


def test_where_the_build_goes_on_comes_first() -> None:
    found = told(UNKNOWN, **TESTS, **{"src/words.cpp": f"{WRONG}int words() {{return 0;}}\n"})
    assert found == [("src/words.cpp", "warning")]


def test_where_all_sources_are_known() -> None:
    assert told("", **TESTS) == []
    assert told("add_library(parts OBJECT src/words.cpp)\nadd_library(all $<TARGET_OBJECTS:parts>)\n", **TESTS) == []


GUARDED = "#if VERSION == 1\n#include <my_pkg/one.hpp>\n#endif\nint words() {return 0;}\n"
OLD_TARGET = "add_executable(old src/old.cpp)\ntarget_include_directories(old PRIVATE include)\n"
OLD = {"src/old.cpp": "#include <my_pkg/one.hpp>\n", "src/words.cpp": GUARDED}


@pytest.mark.parametrize(
    "lines, found",
    [
        ("", []),
        (OLD_TARGET, [("include/my_pkg/one.hpp", "error")]),
    ],
)
def test_what_only_an_uncompiled_source_surely_includes(lines: str, found: list[tuple[str, str]]) -> None:
    assert told(lines, **{**OLD, "include/my_pkg/one.hpp": WRONG}) == found


@pytest.mark.parametrize(
    "more, level",
    [
        ({}, "info"),
        ({"src__words_DOT_cpp": '#include "lost.hpp"\nint words() {return 0;}\n'}, "warning"),
    ],
)
def test_a_header_that_nothing_compiled_includes(more: dict[str, str], level: str) -> None:
    lost = "#include <sensor_msgs/msg/imu.hpp>\n"
    found = told("", "DEP105", **{"src__lost_DOT_hpp": lost, **more})
    assert found == [("src/lost.hpp", level)]
