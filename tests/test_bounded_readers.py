"""Large and deep CMake, C++ and ignore comments: time, memory and recursion are bounded, and what is left out is said.

No test looks at a clock: an algorithm of the wrong order would take minutes here.
"""

from __future__ import annotations

import pytest
from cmaking import read

from rospkg_cli.engine.suppression.comments import in_source
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.languages.cmake.call_stack import MAX_COST
from rospkg_cli.languages.cmake.values import UNKNOWN
from rospkg_cli.ros.license_text import is_prose, licenses_in
from rospkg_cli.source import Source
from rospkg_cli.testing import lint_files

HEAD = "project(my_pkg)\n"
DIGITS = "9" * 5_000
FALLEN = "RPK005"
LOOPS = "".join(f"foreach(i{n} a b)\n" for n in range(40))
NESTED = LOOPS + "list(APPEND x a b c)\nadd_executable(y ${x})\n" + "endforeach()\n" * 40


def package(lines: str, **more: str) -> dict[str, str]:
    cmake = CMAKE.replace("ament_package()", f"{lines}\nament_package()")
    return {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": cmake, **more}


def codes(files: dict[str, str], *wanted: str) -> set[str]:
    return {
        finding.code
        for finding in lint_files(files, [*wanted, FALLEN, "RPK004", "RPK007"] if wanted else None).findings
    }


@pytest.mark.parametrize(
    "lines",
    [
        NESTED,
        "set(x a b)\n" + "set(x ${x} ${x})\n" * 11 + "".join(f"set(y{n} ${{x}})\n" for n in range(9_000)),
        "set(x aaaa)\n" + 'string(APPEND x "${x}")\n' * 14 + "".join(f'set(y{n} "${{x}}b")\n' for n in range(5_000)),
        "set(x " + "a " * 5_000 + ")\n" + "if(WHO)\nlist(APPEND x b)\nendif()\n" * 1_200,
        "".join(f"set(v{n} a)\n" for n in range(2_000)) + "if(WHO)\nset(a b)\nendif()\n" * 2_000,
    ],
)  # fmt: skip
def test_the_sum_of_what_cmake_builds_is_bounded(lines: str) -> None:
    found = read(HEAD + lines)
    assert found.stopped == "it takes too many steps"
    assert sum(len(call.words) + sum(map(len, call.texts)) // 16 for call in found.calls) <= MAX_COST


@pytest.mark.parametrize(
    "command", ["set(x ${x} ${x})", "list(APPEND x ${x})", 'set(x "${x}${x}")', 'string(APPEND x "${x}")']
)
def test_a_list_or_text_that_is_too_long_is_unknown_not_cut_off(command: str) -> None:
    found = read(f"{HEAD}set(x abcd)\n" + f"{command}\n" * 16 + "message(${x})\n")
    assert not found.stopped
    assert UNKNOWN in found.calls[-1].texts[0]


def test_blocks_may_be_nested_deeper_than_python_recurses() -> None:
    lines = "if(A)\n" * 3_000 + "ament_target_dependencies(a b)\n" + "endif()\n" * 3_000
    assert FALLEN not in codes(package(lines))


@pytest.mark.parametrize(
    "each",
    [
        "add_library(t{0} SHARED src/a.cpp)\ntarget_link_libraries(t{0} PUBLIC u{0})\n",
        "add_executable(t{0} src/t{0}.cpp)\n",
        "ament_add_gtest(t{0} test/a.cpp)\n",
        "install(TARGETS t{0} DESTINATION lib)\n",
    ],
)
def test_thousands_of_targets(each: str) -> None:
    lines = "".join(each.format(n) for n in range(2_000))
    assert FALLEN not in codes(package(lines), "CMK102", "CMK103", "CMK104", "CMK107", "CMK110")


@pytest.mark.parametrize("text", ["set(\n" * 30_000, "set(" + 'x"' * 50_000, "#[[\n" * 50_000, "${" * 90_000])
def test_cmake_that_is_never_closed_is_not_read_again_and_again(text: str) -> None:
    found = lint_files({**package(""), "CMakeLists.txt": text}, ["RPK001"]).findings
    assert [finding.location.path for finding in found] == ["CMakeLists.txt"]


def test_a_cmake_file_that_is_too_large_is_skipped_and_that_is_said() -> None:
    (found,) = lint_files(package("set(x " + "a " * 400_000 + ")"), ["RPK007", "CMK003"]).findings
    assert found.code == "RPK007"
    assert "500,000 characters" in found.message


@pytest.mark.parametrize(
    "lines",
    [
        f"if(1.{DIGITS} VERSION_LESS 2)\nendif()\nif({DIGITS} LESS 2)\nendif()",
        f'string(SUBSTRING "a" {DIGITS} 1 x)\nstring(SUBSTRING "a" 0 {DIGITS} x)\nmath(EXPR x "{DIGITS} + 1")',
        f"function(f)\ncmake_parse_arguments(PARSE_ARGV {DIGITS} A a b c)\nendfunction()\nf(x)",
        f"cmake_minimum_required(VERSION {DIGITS}.1)\nlist(GET x {DIGITS} y)\nforeach(i RANGE {DIGITS})\nendforeach()",
    ],
)  # fmt: skip
def test_numbers_may_have_thousands_of_digits(lines: str) -> None:
    more = {
        "CHANGELOG.rst": f"1.2.{DIGITS} (2020-01-01)\n{'-' * 5_020}\n",
        "msg/A.msg": f"string<={DIGITS} a\nint32 B={DIGITS}\n",
    }
    assert FALLEN not in codes({**package(lines), **more})


@pytest.mark.parametrize(
    "text",
    [
        "declare_parameter(" * 6_000,
        "declare_parameter<a>(" * 5_000,
        "declare_parameter<" * 6_000,
        "X_EXPORT_Y({" * 9_000,
        "declare_parameter<int>(" * 3_000 + ")" * 3_000,
        "void f() {" + "{" * 20_000 + 'declare_parameter<int>("a") ' * 3_000,
        f'void f() {{ declare_parameter_if_not_declared({"node_a" * 2_000}, "a", std::vector<{">" * 9_000}); }}',
    ],
)
def test_calls_in_cpp_that_are_never_closed(text: str) -> None:
    assert FALLEN not in codes({**package(""), "src/a.cpp": text})


@pytest.mark.parametrize(
    ("before", "whole"),
    [
        ("\n" * 60_000, True),
        ("// a license\n" * 5_000, True),
        ("<!--" * 16_000, True),
        ("<!-- a -->" * 4_000, True),
        ("<?" * 30_000, False),
        ("<?xml?><!-- a\n b -->\n", True),
        ("# a ", True),
        ("int a;\n", False),
        ("<a/> <!-- b -->", False),
    ],
)
def test_the_head_of_a_file_is_found_in_one_pass(before: str, whole: bool) -> None:
    (found,) = in_source(Source("a.xml", f"{before}// rospkg: ignore-file[XML101] a reason\n"), "a.xml")
    assert (found.lines == ()) is whole


def test_thousands_of_ignore_comments() -> None:
    lines = "// rospkg: ignore-file[CMK001] a\n" * 8_000
    assert all(each.lines == () for each in in_source(Source("a.cpp", lines), "a.cpp"))
    open_ones = list(in_source(Source("a.xml", "<!-- rospkg: ignore[CMK001] a\n" * 8_000), "a.xml"))
    assert sum(len(each.reason) for each in open_ones) == 8_000
    unknown = "".join(f"// rospkg: ignore[CMK{n}x] a\n" for n in range(1_500))
    assert FALLEN not in codes({**package(""), "src/a.cpp": unknown + lines}, "RPK002", "CMK103")


def test_a_license_of_many_words_is_prose() -> None:
    text = "the " * 9_000 + " " * 9_000
    assert licenses_in(text) == [text]
    assert is_prose(text)
