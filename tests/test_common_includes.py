"""What every branch of a condition includes is always included."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.languages.cpp.common_includes import common_includes
from rospkg_cli.languages.cpp.file import read_cpp
from rospkg_cli.source import Source
from rospkg_cli.testing import lint_files

A, A2, B = "#include <a/x.h>\n", '#include "a/x.hpp"\n', "#include <b/x.h>\n"


@pytest.mark.parametrize(
    "text, folders",
    [
        (f"#if X\n{A}#else\n{A2}#endif\n", {"a"}),
        (f"#ifdef X\n{A}#else\n{A2}#endif\n", {"a"}),
        (f"#if X\n{A}#elif Y\n{A}#else\n{A2}{B}#endif\n", {"a"}),
        (f"#if X\n{A}#elif Y\n{A}#endif\n", set()),
        (f"#if X\n{A}#elif Y\n{B}#else\n{A2}#endif\n", set()),
        (f"#if X\n{A}#endif\n", set()),
        (f"#if X\n#if Y\n{A}#else\n{A}#endif\n#else\n{A2}#endif\n", {"a"}),
        (f"#if X\n#if Y\n{A}#endif\n#else\n{A2}#endif\n", set()),
        (f"#ifndef A_H\n#define A_H\n#if X\n{A}#else\n{A2}#endif\n#endif\n", {"a"}),
        (f"#ifndef A_H\n#if X\n{A}#else\n{A2}#endif\n#endif\n", set()),
        (f"#if Z\n#endif\n#ifndef A_H\n#define A_H\n#if X\n{A}#else\n{A2}#endif\n#endif\n", set()),
        (f"#if X\n/*\n{A}*/\n#else\n{A2}#endif\n", set()),
        ("#endif\n#else\n#ifndef A", set()),
        (f"{A}  # if X\n  {B}# else\n\t{B}# endif\n", {"a", "b"}),
        ("#if X\n#include <a.h>\n#else\n#include <a.h>\n#endif\n", set()),
    ],
)
def test_what_all_branches_include(text: str, folders: set[str]) -> None:
    includes = read_cpp(Source("a.hpp", text)).includes
    assert common_includes(text, {each.span.start for each in includes}) == folders


def undeclared(text: str) -> list[str]:
    lines = CMAKE.replace("ament_package()", "add_executable(node src/node.cpp)\nament_package()")
    files = {**existing_files(BACKDROPS["ament_cmake"]), "package.xml": manifest("", "ament_cmake")}
    found = lint_files({**files, "CMakeLists.txt": lines, "src/node.cpp": text}, ["DEP105"]).findings
    return [f.message.split("`")[1] for f in found]


def test_a_package_that_both_branches_include_must_be_declared() -> None:
    old, new = "#include <cv_bridge/cv_bridge.h>\n", "#include <cv_bridge/cv_bridge.hpp>\n"
    assert undeclared(f"#if __has_include(<cv_bridge/cv_bridge.hpp>)\n{new}#else\n{old}#endif\n") != []
    assert undeclared(f"#if X\n{new}#else\n#include <string>\n#endif\n") == []
