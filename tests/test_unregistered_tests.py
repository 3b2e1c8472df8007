"""Python tests of CMake packages that no command registers: nobody meets what is wrong in them."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

TEST = "import unittest\n\n\nclass Moves(unittest.TestCase):\n    def test_a(self):\n        self.assertTrue(plan())\n"
FIND = "  find_package(ament_cmake_pytest REQUIRED)\n"


@pytest.mark.parametrize(
    ("name", "line", "levels"),
    [
        ("moves.py", "ament_add_pytest_test(moves test/moves.py)", ["warning"]),
        ("moves.py", "# ament_add_pytest_test(moves test/moves.py)", ["info"]),
        ("moves.py", "install(FILES test/moves.py DESTINATION share/my_pkg)", ["info"]),
        ("moves.py", "install(DIRECTORY test DESTINATION share/my_pkg)", ["info"]),
        ("moves.py", "ament_add_pytest_test(all test)", ["info"]),
        ("test_moves.py", "ament_add_pytest_test(all test)", ["warning"]),
        ("moves.py", "", ["info"]),
        ("test_moves.py", "", ["info"]),
    ],
)
def test_what_is_undefined_in_a_test(name: str, line: str, levels: list[str]) -> None:
    lines = f"if(BUILD_TESTING)\n{FIND}  {line}\nendif()\n"
    files = {
        "package.xml": manifest("  <test_depend>ament_cmake_pytest</test_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}ament_package"),
        f"test/{name}": TEST,
    }
    assert [each.severity.value for each in lint_files(files, ["DEP117"]).findings] == levels


def test_what_another_test_imports() -> None:
    lines = f"if(BUILD_TESTING)\n{FIND}  ament_add_pytest_test(moves test/test_moves.py)\nendif()\n"
    files = {
        "package.xml": manifest("  <test_depend>ament_cmake_pytest</test_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}ament_package"),
        "test/test_moves.py": "from moves import Moves\n",
        "test/moves.py": TEST,
    }
    assert [each.severity.value for each in lint_files(files, ["DEP117"]).findings] == ["warning"]
