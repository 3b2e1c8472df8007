"""Conditions in blocks, which CMake may not come to (CMK123), and lists that nobody is shown to miss (CMK115)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE
from rospkg_cli.testing import lint_files

OPERAND = "if(${CMAKE_BUILD_TYPE} STREQUAL Debug)\nendif()\n"


def levels(code: str, lines: str) -> list[str]:
    text = CMAKE.replace("ament_package()", f"{lines}ament_package()")
    files = {**BACKDROPS["ament_cmake"], "CMakeLists.txt": text, "src/a.cpp": "\n"}
    return [each.severity.value for each in lint_files(files, [code]).findings]


@pytest.mark.parametrize(
    ("lines", "level"),
    [
        (OPERAND, "warning"),
        (f"if(ACME_TESTS)\n{OPERAND}endif()\n", "info"),
        (f"function(acme)\n{OPERAND}endfunction()\n", "info"),
        (f"if(ACME_TESTS)\n{OPERAND}endif()\n{OPERAND}", "warning"),
    ],
)
def test_a_condition_in_a_block_may_not_be_met(lines: str, level: str) -> None:
    assert levels("CMK123", lines) == [level]


def test_nobody_is_shown_to_miss_what_a_list_lacks() -> None:
    lines = "set(CORE_FLAGS -Wall)\nlist(APPEND CORE_FALGS -Wextra)\nadd_compile_options(${CORE_FLAGS})\n"
    assert levels("CMK115", lines) == ["info"]
