"""A syntax error is told by default, whatever stands in its line, in each kind of file that colcon or launch runs."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, SETUP_PY, scripts, setup_py
from rospkg_cli.testing import lint_files

LAUNCH = "from launch import LaunchDescription\n\n\ndef generate_launch_description():\n    {}\n"
BROKEN = {
    "setup.py": SETUP_PY.replace("'share/' + package_name, ['package.xml']", "f'share/{package_name}', ['package.xml'"),
    "launch/robot.launch.py": LAUNCH.format("return LaunchDescription(]"),
    "my_pkg/talker.py": "def main():\n    while True:\n        break]\n",
    "my_pkg/listener.py": "def main():\n    for each in (1, 2):\n        continue f'{each}'\n",
}


@pytest.mark.parametrize("path", BROKEN)
def test_a_syntax_error_is_told(path: str) -> None:
    setup = setup_py(scripts("talker = my_pkg.talker:main", "listener = my_pkg.listener:main"))
    files = {**BACKDROPS["ament_python"], "setup.py": setup, path: BROKEN[path]}
    found = [each for each in lint_files(files, None).findings if each.code == "RPK001"]
    assert [each.location.path for each in found] == [path]
    assert found[0].severity.value == "error"


REFUSED = {
    "setup.py": SETUP_PY.replace("    version=", "    version='1.0.0',\n    version=", 1),
    "launch/robot.launch.py": LAUNCH.format("return LaunchDescription([Node(name='a', name='b')])"),
    "my_pkg/talker.py": "def main(node, node):\n    pass\n",
    "my_pkg/listener.py": "def main():\n    pass\n\n\nif main:\n    return\n",
}


@pytest.mark.parametrize("path", REFUSED)
def test_what_the_compiler_refuses_is_told(path: str) -> None:
    """Nobody comes to another fault of the file, such as an undefined name, before that is mended."""
    setup = setup_py(scripts("talker = my_pkg.talker:main", "listener = my_pkg.listener:main"))
    refused = f"{REFUSED[path]}\nundefined_name()\n"
    files = {**BACKDROPS["ament_python"], "setup.py": setup, path: refused}
    found = [each for each in lint_files(files, None).findings if each.location.path == path]
    assert [(each.code, each.severity.value) for each in found] == [("RPK001", "error")]


TEST = "def test_it():\n    assert (1\n"
REGISTERED = "find_package(ament_cmake_pytest REQUIRED)\n{}\nament_package()"


@pytest.mark.parametrize("path", ["test/test_it.py", "test/it_test.py", "tests/deep/test_it.py"])
def test_a_test_that_pytest_cannot_read_is_told(path: str) -> None:
    assert broken({**BACKDROPS["ament_python"], path: TEST}) == [path]


@pytest.mark.parametrize("path", ["test/helper.py", "scripts/test_it.py"])
def test_what_pytest_does_not_find_may_be_broken(path: str) -> None:
    assert broken({**BACKDROPS["ament_python"], path: TEST}) == []


@pytest.mark.parametrize(
    ("call", "path", "is_told"),
    [
        ("ament_add_pytest_test(it test/it.py)", "test/it.py", True),
        ("add_launch_test(test/it.py TIMEOUT 60)", "test/it.py", True),
        ("add_ros_test(${CMAKE_CURRENT_SOURCE_DIR}/test/it.py)", "test/it.py", True),
        ("ament_add_test(it COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/test/it.py)", "test/it.py", True),
        ("ament_add_pytest_test(it test/${name})", "test/it.py", False),
        ("ament_add_gtest(it test/it.py)", "test/it.py", False),
        ("ament_add_pytest_test(it test/it)", "test/test_it.py", False),
    ],
)
def test_a_test_that_cmake_registers_is_told(call: str, path: str, is_told: bool) -> None:
    text = BACKDROPS["ament_cmake"]["CMakeLists.txt"].replace("ament_package()", REGISTERED.format(call))
    assert broken({**BACKDROPS["ament_cmake"], "CMakeLists.txt": text, path: TEST}) == [path] * is_told


@pytest.mark.parametrize(
    ("text", "is_told"), [("import helper\n", True), ("from .helper import a\n", False), ("import help\n", False)]
)
def test_what_a_test_imports_from_beside_it_is_told(text: str, is_told: bool) -> None:
    files = {**BACKDROPS["ament_python"], "test/test_it.py": text, "test/helper.py": TEST}
    assert broken(files) == ["test/helper.py"] * is_told


def broken(files: dict[str, str]) -> list[str]:
    return [each.location.path for each in lint_files(files, ["RPK001"]).findings]
