"""Headers of a package that has nothing else: what its tests include, and who else is built with it (CMK201)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

HEADERS = "install(DIRECTORY include/ DESTINATION include)\n"
TEST = """\
if(BUILD_TESTING)
  find_package(ament_cmake_gtest REQUIRED)
  ament_add_gtest(test_gears test/test_gears.cpp)
endif()
"""
FILES = {
    "base/package.xml": manifest("", "ament_cmake", "base"),
    "base/include/base/gear_reduction.hpp": "namespace base\n{\nclass Gear\n{\n};\n}  // namespace base\n",
    "base/include/base/parser.hpp": '#include "base/gear_reduction_info.hpp"\nstd::vector<Infos> parse();\n',
    "base/test/test_gears.cpp": '#include "base/gear_reduction.hpp"\nint main() {return 0;}\n',
}
USER = {
    "user/package.xml": manifest("  <depend>base</depend>\n", "ament_cmake", "user"),
    "user/CMakeLists.txt": CMAKE.replace("my_pkg", "user").replace(
        "ament_package", "find_package(base REQUIRED)\nadd_executable(a src/a.cpp)\nament_package"
    ),
    "user/src/a.cpp": "int main() {return 0;}\n",
}
GATHERS = {
    "all/package.xml": manifest("  <exec_depend>base</exec_depend>\n", "ament_cmake", "all"),
    "all/CMakeLists.txt": CMAKE.replace("my_pkg", "all"),
}


def told(lines: str, **more: str) -> list[tuple[str, str]]:
    """Return the level, and the header that is near."""
    cmake = CMAKE.replace("my_pkg", "base").replace("ament_package", f"{HEADERS}{lines}ament_package")
    found = lint_files({**FILES, "base/CMakeLists.txt": cmake, **more}, ["CMK201"]).findings
    return [(each.severity.value, each.message.partition("did you mean `")[2].partition("`")[0]) for each in found]


@pytest.mark.parametrize(
    ("lines", "more", "level"),
    [
        (TEST, {}, "info"),
        (TEST, GATHERS, "info"),
        (TEST, USER, "warning"),
        (TEST, {"base/test/test_gears.cpp": '#include "base/parser.hpp"\n'}, "warning"),
        (TEST, {"base/include/base/gear_reduction.hpp": '#include "base/parser.hpp"\n'}, "warning"),
        ("", {}, "warning"),
        ("add_library(gone ${WHEREVER})\n" + TEST, {}, "warning"),
    ],
)
def test_who_meets_a_header(lines: str, more: dict[str, str], level: str) -> None:
    assert [found for found, _ in told(lines, **more)] == [level]


@pytest.mark.parametrize(
    ("text", "near"),
    [
        ('#include "base/gear_reduction_info.hpp"\nstd::vector<Infos> parse();\n', ""),
        ('#include "base/gear_reduction_info.hpp"\n/// of a Gear\nstd::vector<Infos> parse();\n', ""),
        ('#include "base/gear_reduction_info.hpp"\nstd::vector<Gear> parse();\n', "base/gear_reduction.hpp"),
        ('#include "base/gaer_reduction.hpp"\nint parse();\n', "base/gear_reduction.hpp"),
        ('#include "base/gear_reduction.h"\nint parse();\n', "base/gear_reduction.hpp"),
        ('#include "base/more/gear_reduction.hpp"\nint parse();\n', "base/gear_reduction.hpp"),
    ],
)
def test_a_near_header_holds_what_is_used(text: str, near: str) -> None:
    assert [found for _, found in told("", **{"base/include/base/parser.hpp": text})] == [near]


def test_a_near_header_without_classes() -> None:
    more = {"base/include/base/gear_reduction.hpp": "namespace base\n{\nclass Other;\ntemplate<class T> T turn();\n}\n"}
    assert told("", **more) == [("warning", "base/gear_reduction.hpp")]
