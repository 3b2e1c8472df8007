"""Headers that no compiled source includes and nothing installs: nobody meets what stands in them."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files
from rospkg_cli.testing import lint_files

NATIVE = existing_files(BACKDROPS["ament_cmake"])
HEADER = '#pragma once\nstd::string where() {return "/home/ada/ws/src/my_pkg/config/bus.yaml";}\n'
FILES = {
    **NATIVE,
    "include/my_pkg/hardware.hpp": HEADER,
    "src/hardware.cpp": '#include "my_pkg/hardware.hpp"\n',
    "src/node.cpp": "int main() {return 0;}\n",
    "config/bus.yaml": "slaves: 2\n",
}
LEFT = "#add_library(hardware SHARED\n#  src/hardware.cpp)\ninstall(DIRECTORY config DESTINATION share/my_pkg)\n"
NODE = "add_executable(node src/node.cpp)\n"


def level(lines: str, **more: str) -> str:
    build = CMAKE.replace("ament_package", f"{lines}ament_package")
    (found,) = lint_files({**FILES, "CMakeLists.txt": build, **more}, ["DEP118"]).findings
    return found.severity.value


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (LEFT, "info"),
        (LEFT + NODE, "info"),
        ("add_library(hardware SHARED src/hardware.cpp)\n", "warning"),
        (f"{LEFT}add_library(headers INTERFACE)\ninstall(DIRECTORY include/ DESTINATION include)\n", "warning"),
        (f"{LEFT}install(FILES include/my_pkg/hardware.hpp DESTINATION include/my_pkg)\n", "warning"),
        (f"{LEFT}install(FILES include/my_pkg/other.hpp DESTINATION include/my_pkg)\n", "info"),
        (f"{LEFT}add_subdirectory(${{ELSEWHERE}})\n", "warning"),  # which may compile or install it
    ],
)
def test_a_header_counts_where_it_is_compiled_or_installed(lines: str, expected: str) -> None:
    assert level(lines) == expected


@pytest.mark.parametrize(("lines", "expected"), [(LEFT, "info"), ("", "warning")])
def test_a_source_whose_library_is_a_comment(lines: str, expected: str) -> None:
    source = 'std::string where() {return "/home/ada/ws/src/my_pkg/config/bus.yaml";}\n'
    files = {path: text for path, text in FILES.items() if not path.endswith((".hpp", ".cpp"))}
    build = CMAKE.replace("ament_package", f"{lines}ament_package")
    files |= {"CMakeLists.txt": build, "src/hardware.cpp": source}
    (found,) = lint_files(files, ["DEP118"]).findings
    assert found.severity.value == expected  # where no comment tells, the build may be forgotten


@pytest.mark.parametrize(("included", "expected"), [("other", "warning"), ("none", "info")])
def test_a_header_that_an_installed_one_includes_is_met(included: str, expected: str) -> None:
    texts = {"include/my_pkg/other.hpp": '#include "my_pkg/hardware.hpp"\n', "include/my_pkg/none.hpp": "\n"}
    lines = f"{LEFT}install(FILES include/my_pkg/{included}.hpp DESTINATION include/my_pkg)\n"
    assert level(lines, **texts) == expected


def test_a_header_that_another_header_of_a_program_includes_is_met() -> None:
    texts = {"src/node.cpp": '#include "node.hpp"\n', "src/node.hpp": "#include <my_pkg/hardware.hpp>\n"}
    assert level(LEFT + NODE, **texts) == "warning"
