"""Nodes in Python without an executable bit, of which CMake installs all but one."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.cmake.left_out_nodes import is_left_out
from rospkg_cli.files import PackageFiles
from rospkg_cli.tree import MemoryTree

NODE = "import rclpy\nif __name__ == '__main__':\n    rclpy.init()\n"
OTHERS = {"scripts/filter.py": "import rclpy\n", "scripts/hello.py": "if __name__ == '__main__':\n    print()\n",
          "scripts/talker": NODE, "other/talker.py": NODE}  # fmt: skip


@pytest.mark.parametrize(
    "names, installed, expected",
    [
        ("abc", "ab", {"scripts/c.py"}),
        ("abc", "a", set()),
        ("abc", "abc", set()),
        ("ab", "a", set()),
        ("abcd", "abd", {"scripts/c.py"}),
    ],
)
def test_the_one_node_that_is_not_installed(names: str, installed: str, expected: set[str]) -> None:
    files = PackageFiles(MemoryTree.of({**OTHERS, **{f"scripts/{name}.py": NODE for name in names}}))
    there = {f"scripts/{name}.py" for name in installed}
    assert {path for path in files.paths if is_left_out(path, files, there.__contains__)} == expected
