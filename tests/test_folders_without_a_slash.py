"""CMK123: a folder of the package without its slash is loud where the build needs what lies there."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

INCLUDES = "include_directories(${{PROJECT_SOURCE_DIR}}src/base{})\nadd_executable(node src/node.cpp)\n"
LINKS = "link_directories(${PROJECT_SOURCE_DIR}lib)\nadd_executable(node src/node.cpp)\n"
SETS = "set(folder ${PROJECT_SOURCE_DIR}lib)\nadd_executable(node src/node.cpp)\n"


def told(lines: str, files: dict[str, str]) -> list[str]:
    own = {"package.xml": manifest("", "ament_cmake"), "src/node.cpp": "int main() {return 0;}\n", **files}
    found = lint_files({**own, "CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}ament_package")}, ["CMK123"])
    return [f"{each.severity.value}: {each.message.rpartition('; ')[2]}" for each in found.findings]


@pytest.mark.parametrize(
    ("include", "more", "expected"),
    [
        ('"a.h"', "", "warning"),
        ('"a.h"', " src/base", "info"),
        ('"base/a.h"', " src", "info"),
        ('"base/a.h"', "", "info"),
        ("<base/a.h>", "", "info"),
        ("<a.h>", "", "warning"),
        ("<vector>", "", "info"),
    ],
)
def test_headers_that_are_found_otherwise(include: str, more: str, expected: str) -> None:
    files = {"src/node.cpp": f"#include {include}\nint main() {{return 0;}}\n", "src/base/a.h": "", "src/base/b.h": ""}
    (found,) = told(INCLUDES.format(more), files)
    assert found.startswith(expected)


def test_headers_beside_the_file_that_includes_them() -> None:
    files = {"src/base/a.cpp": '#include "a.h"\n', "src/base/a.h": ""}
    assert told(INCLUDES.format(""), files) == ["info: all headers are found without it"]
    files = {"src/base/a.cpp": "#include <a.h>\n", "src/base/a.h": ""}
    (found,) = told(INCLUDES.format(""), files)
    assert found.startswith("warning")


def test_libraries_and_values() -> None:
    assert told(LINKS, {"lib/README.md": "a\n"}) == ["info: no library lies there"]
    (found,) = told(LINKS, {"lib/libmotor.so": ""})
    assert found.startswith("warning")
    assert told(SETS, {"lib/a.txt": ""}) == ["info: nothing here reads `folder`"]
    (found,) = told(f"{SETS}file(GLOB files ${{folder}}/*.txt)\n", {"lib/a.txt": ""})
    assert found.startswith("warning")
    assert told("message(STATUS ${PROJECT_SOURCE_DIR}lib)\n", {"lib/a.txt": ""}) == ["info: it is only shown"]
