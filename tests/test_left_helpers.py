"""A Python file beside launch files that launch can't start and no other one takes: its functions are never called."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.launch.idle_actions import NEVER_CALLED, NO_ENTRY
from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

HELPER = """\
import os

from ament_index_python.packages import get_package_share_directory


def load():
    with open(os.path.join(get_package_share_directory('my_pkg'), 'config', 'old.yaml')) as file:
        return file.read()


def build(model):
    return [model, load()]
"""
BUILD = "cmake_minimum_required(VERSION 3.14)\nproject(my_pkg)\nfind_package(ament_cmake REQUIRED)\n"
INSTALLED = f"{BUILD}install(DIRECTORY launch DESTINATION share/${{PROJECT_NAME}})\nament_package()\n"
LAUNCH = "\n\ndef generate_launch_description():\n    return LaunchDescription([])\n"


def told(helper: str = HELPER, more: dict[str, str] | None = None, name: str = "launch/common.py") -> tuple[str, str]:
    own = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": INSTALLED, name: helper, **(more or {})}
    files = {f"my_pkg/{path}".replace("my_pkg/../", ""): text for path, text in own.items()}
    (found,) = lint_files(files, ["LCH003"]).findings
    return found.severity.value, found.message


def test_a_function_of_a_helper_that_nothing_imports_is_never_called() -> None:
    level, message = told()
    assert level == "info"
    assert f", {NEVER_CALLED}; " in message


@pytest.mark.parametrize(
    "taking",
    [
        "from common import build",
        "from my_pkg.launch.common import (\n    build,\n)",
        "from .common import build",
        "import common as shared",
        "import importlib\n\ncommon = importlib.import_module('common')",
        "common = __import__('common')",
        "from importlib.machinery import SourceFileLoader\n\nSourceFileLoader('a', path + '/common.py')",
    ],
)
def test_a_helper_that_a_launch_file_takes_may_be_called(taking: str) -> None:
    launch = f"from launch import LaunchDescription\n{taking}{LAUNCH}"
    level, message = told(more={"launch/a.launch.py": launch})
    assert level == "warning"
    assert f", {NO_ENTRY}; " in message


def test_a_helper_that_another_package_takes_may_be_called() -> None:
    launch = (
        f"import sys\n\nfrom launch import LaunchDescription\n\nsys.path.append('x')\nfrom common import build{LAUNCH}"
    )
    other = {"../other/package.xml": manifest("", "ament_cmake", "other"), "../other/launch/a.launch.py": launch}
    other["../other/CMakeLists.txt"] = INSTALLED.replace("my_pkg", "other")
    assert told(more=other)[0] == "warning"
    assert told(more={**other, "../other/launch/a.launch.py": launch.replace("common", "more")})[0] == "info"


@pytest.mark.parametrize(
    "helper",
    [
        f"{HELPER}\n\nMODELS = build('a')\n",
        HELPER.replace("def load():\n    with open(", "def load(path=open(").replace(")) as file:", "))):"),
        f"from my_tools import register\n{HELPER.replace('def load', '@register' + chr(10) + 'def load')}",
    ],
)
def test_what_the_file_may_call_itself_stays_a_warning(helper: str) -> None:
    assert told(helper.replace("        return file.read()", "        return ''"))[0] == "warning"


def test_modules_for_others_and_tests_stay_warnings() -> None:
    assert told(more={"launch/__init__.py": ""})[0] == "warning"
    assert told(name="launch/test_common.py")[0] == "warning"
