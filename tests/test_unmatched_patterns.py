"""Folders that are installed with a pattern that none of their files fits (CMK129)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

CODES = ["CMK101", "CMK106", "CMK129"]
HEADERS = {"include/my_pkg/a.hpp": "#pragma once\n", "include/my_pkg/b.hpp": "#pragma once\n"}
LAUNCH = {"launch/a.launch.xml": "<launch/>\n"}
SHARE = "install(DIRECTORY launch DESTINATION share/my_pkg FILES_MATCHING PATTERN "
PLAIN = "install(DIRECTORY include/ DESTINATION include FILES_MATCHING PATTERN "


def told(lines: str, files: dict[str, str]) -> list[str]:
    """Return code and level of each finding."""
    cmake = CMAKE.replace("ament_package()", f"{lines}\nament_package()")
    found = lint_files({"CMakeLists.txt": cmake, "package.xml": manifest("", "ament_cmake"), **files}, CODES).findings
    return [f"{each.code} {each.severity.value}" for each in found]


@pytest.mark.parametrize(
    ("lines", "files", "expected"),
    [
        (f'{PLAIN}"*.h")', HEADERS, ["CMK129 info"]),
        (f'{PLAIN}"*.h" PATTERN ".svn" EXCLUDE)', HEADERS, ["CMK129 info"]),
        (f'{PLAIN}"*.h")\nament_export_include_directories(include)', HEADERS, ["CMK129 info"]),
        (f'{PLAIN}"*.h")\ninstall(DIRECTORY include/ DESTINATION include)', HEADERS, ["CMK129 info"]),
        (f'{PLAIN}"*.h")\n{PLAIN}"*.hpp")', HEADERS, []),
        (f'{PLAIN}"*.h" PATTERN "*.hpp")', HEADERS, []),
        (f'{PLAIN}"*.h*")', HEADERS, []),
        (f'{PLAIN}"*.so")', HEADERS, []),
        (f'{PLAIN}"*.h")', {"include/my_pkg/a.txt": "\n"}, []),
        (f'{PLAIN}"*.h")', {**HEADERS, ".gitignore": "*.h\n"}, []),
        (f'if(X)\n{PLAIN}"*.h")\nendif()', HEADERS, []),
        (PLAIN.replace("PATTERN", "REGEX") + '"h$")', HEADERS, []),
        (PLAIN.replace("include/ ", "${WHERE} ") + '"*.h")', HEADERS, []),
        (PLAIN.replace("include/ ", "headers ") + '"*.h")', HEADERS, []),
        (f'{SHARE}"*.launch")', LAUNCH, ["CMK129 warning"]),
        (f'{SHARE}"*.launch.*")', LAUNCH, []),
        (f'{SHARE}"*.urdf")', LAUNCH, ["CMK101 warning"]),
    ],
)
def test_patterns(lines: str, files: dict[str, str], expected: list[str]) -> None:
    assert told(lines, files) == expected
