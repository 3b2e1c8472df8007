"""Paths under a macro of C++ that nothing defines: the build leaves them out."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.languages.cpp.asked_macros import asked_macros
from rospkg_cli.testing import lint_files

PLACE = "/home/ada/ws/src/my_pkg/data/a.txt"
CODE = f'#include <fstream>\nint main()\n{{\nOPEN\n  std::ifstream in("{PLACE}");\n#endif\n}}\n'
BUILD = CMAKE.replace("ament_package", "EXTRA\nadd_executable(node src/node.cpp)\nament_package")


def level(opening: str, extra: str = "") -> str:
    code = CODE.replace("OPEN", opening)
    code = code if opening else code.replace("#endif\n", "")
    files = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": BUILD.replace("EXTRA", extra)}
    (found,) = lint_files({**files, "src/node.cpp": code, "data/a.txt": ""}, ["DEP118"]).findings
    return found.severity.value


@pytest.mark.parametrize(
    ("opening", "extra", "expected"),
    [
        ("", "", "warning"),
        ("#if 0", "", "info"),
        ("#ifdef TRACE", "", "info"),
        ("#if defined(TRACE) // keeps a file", "", "info"),
        ("#if defined(TRACE) && defined(__linux__)", "", "info"),
        ("#ifdef __APPLE__", "", "info"),
        ("#ifdef TRACE", "add_compile_definitions(TRACE)", "warning"),
        ("#ifdef TRACE", "add_definitions(-DTRACE)", "warning"),
        ("#ifdef __linux__", "", "warning"),
        ("#ifndef TRACE", "", "warning"),
        ("#ifdef TRACE\n#else", "", "warning"),
        ("#if defined(TRACE) || defined(__linux__)", "", "warning"),
        ("#ifdef TRACE\n#endif\n#ifdef NDEBUG", "", "warning"),
    ],
)
def test_what_the_build_leaves_out(opening: str, extra: str, expected: str) -> None:
    assert level(opening, extra) == expected


def test_macros_around_a_place() -> None:
    text = "#ifdef A\n#if defined(B) && C\n#ifndef D\nx\n#endif\n#endif\n#elif E\ny\n#endif\n"
    assert asked_macros(text, text.index("x")) == {"A", "B", "C"}
    assert not asked_macros(text, text.index("y"))
