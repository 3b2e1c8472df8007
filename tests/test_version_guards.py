"""Attributes of modules in branches for other versions of Python (DEP117)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

FILES = {
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    "my_pkg/__init__.py": "",
}
START = "import collections\nimport os\nimport platform\nimport sys\n\nimport six\n\n\ndef main():\n"


def found(lines: str) -> int:
    files = {**FILES, "my_pkg/talker.py": START + "".join(f"    {line}\n" for line in lines.splitlines())}
    return len(lint_files(files, ["DEP117"]).findings)


@pytest.mark.parametrize(
    "condition",
    [
        "sys.version_info[0] == 2",
        "sys.version_info.major < 3",
        "sys.version_info < (3, 10)",
        "sys.version_info[:2] <= (3, 9)",
        "sys.version_info <= (2, 7)",
        "sys.version[0] == '2'",
        "sys.hexversion < 0x03000000",
        "six.PY2",
        "not six.PY3",
        "six.PY2 or sys.version_info[0] == 2",
        "platform.python_version().startswith('2')",
        "os.environ['ROS_PYTHON_VERSION'] == '2'",
        "os.environ.get('ROS_DISTRO') == 'melodic'",
    ],
)
def test_a_branch_for_another_python_is_left_alone(condition: str) -> None:
    assert found(f"if {condition}:\n    sys.setdefaultencoding('utf-8')\n    print(collections.Mapping)") == 0
    assert found(f"print(collections.Mapping if {condition} else 1)") == 0


@pytest.mark.parametrize("condition", ["sys.version_info[0] >= 3", "six.PY3", "sys.version_info >= (3,)", "not PY2"])
def test_the_other_branch_is_for_it_then(condition: str) -> None:
    lines = f"PY2 = sys.version_info[0] == 2\nif {condition}:\n    {{}}\nelse:\n    {{}}"
    assert found(lines.format("pass", "print(collections.Mapping)")) == 0
    assert found(lines.format("print(collections.Mapping)", "pass")) == 1


@pytest.mark.parametrize("condition", ["sys.argv", "len(sys.path) == 2", "os.environ['MODE'] == '2'"])
def test_another_condition_is_no_guard(condition: str) -> None:
    assert found(f"if {condition}:\n    print(collections.Mapping)") == 1
