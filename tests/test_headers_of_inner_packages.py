"""Headers of a package that lies inside of another one, whose CMake looks for them there: nobody else brings them."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

INNER = CMAKE.replace("my_pkg", "spline").replace("ament_package", "add_library(spline src/curve.cpp)\nament_package")
CURVE = '#include "spline/curve.hpp"\n'
SPLINE = {
    "CMakeLists.txt": INNER.replace("add_library", "include_directories(include)\nadd_library"),
    "package.xml": manifest("", "ament_cmake").replace("my_pkg", "spline"),
    "include/spline/curve.hpp": "#pragma once\n",
    "src/curve.cpp": CURVE,
}
NODE = "add_executable(node src/node.cpp)\ninstall(TARGETS node DESTINATION lib/my_pkg)\n"
NONE: Mapping[str, str] = {}
CODES = ["DEP104", "DEP105", "CMK201"]


def told(
    lines: str, include: str = CURVE, inner: Mapping[str, str] = NONE, other: Mapping[str, str] = NONE
) -> list[tuple[str, str]]:
    """Return what is told of a planner with a package inside, beside a package of the same name."""
    planner = {
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}{NODE}ament_package"),
        "package.xml": manifest("", "ament_cmake"),
        "src/node.cpp": f"{include}int main() {{return 0;}}\n",
        **{f"planner/spline/{path}": text for path, text in {**SPLINE, **inner}.items()},
    }
    files = {f"src/planner/{path}": text for path, text in planner.items()}
    files |= {f"src/spline/{path}": text for path, text in {**SPLINE, **other}.items()}
    found = lint_files(files, CODES).findings
    return [(each.code, each.severity.value) for each in found if each.location.path.startswith("src/planner/")]


@pytest.mark.parametrize(
    "lines",
    [
        "include_directories(planner/spline/include)\nadd_subdirectory(planner/spline)\n",
        "include_directories(./planner/spline/include)\n",
        "add_subdirectory(planner/spline)\n",
        "include_directories(${CMAKE_CURRENT_SOURCE_DIR}/planner/spline/include)\n",
        "set(INNER planner/spline)\ninclude_directories(${INNER}/include)\n",
    ],
)
def test_what_cmake_finds_inside_is_of_no_other_package(lines: str) -> None:
    assert told(lines) == []


def test_a_header_that_only_the_inner_package_has_is_there() -> None:
    lines, knots = "include_directories(planner/spline/include)\n", {"include/spline/knots.hpp": "#pragma once\n"}
    assert told(lines, '#include "spline/knots.hpp"\n', knots) == []
    assert told("", '#include "spline/knots.hpp"\n') == [("CMK201", "error"), ("DEP105", "warning")]


def test_what_cmake_does_not_look_into_is_of_the_other_package() -> None:
    assert told("") == [("DEP105", "warning")]
    assert told("include_directories(planner/other/include)\n") == [("DEP105", "warning")]


def test_a_header_that_the_inner_package_lacks_is_of_the_other_one() -> None:
    lines = "include_directories(planner/spline/include)\n"
    found = told(lines, '#include "spline/lattice.hpp"\n', other={"include/spline/lattice.hpp": "#pragma once\n"})
    assert found == [("DEP105", "warning")]
