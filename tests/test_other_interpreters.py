"""Files that another interpreter runs, inside of a program or on a microcontroller: rosdep installs nothing for it."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, setup_py
from rospkg_cli.example import scripts as programs
from rospkg_cli.testing import lint_files


def levels(text: str) -> list[str]:
    files = {
        **existing_files(BACKDROPS["ament_python"]),
        "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
        "my_pkg/talker.py": f"{text}\nimport serial\n",
    }
    return [each.severity.value for each in lint_files(files, ["DEP101"]).findings]


@pytest.mark.parametrize(
    "text", ["import bpy", "from omni.isaac.kit import App", "from controller import Robot", "from machine import Pin"]
)
def test_what_another_interpreter_runs(text: str) -> None:
    assert levels(text) == ["info"]


@pytest.mark.parametrize(
    "text",
    [
        "import json",
        "from controller import Arm",
        "from .bpy import a",
        "try:\n    import bpy\nexcept ImportError:\n    0",
    ],
)
def test_what_ros_runs(text: str) -> None:
    assert levels(text) == ["warning"]


HOST = "from isaaclab.app import AppLauncher\n"


def level(talker: str, scripts: tuple[str, ...] = ("sim",), name: str = "serial", **more: str) -> str:
    """Lint a package whose `talker` imports a library, and whose programs import it."""
    entries = programs(*(f"{each} = my_pkg.{each}:main" for each in scripts))
    files = {
        **existing_files(BACKDROPS["ament_python"]),
        "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
        "my_pkg/talker.py": f"{talker}\nimport {name}\ndef main(): 0\n",
        **{f"my_pkg/{path}.py": f"{text}def main(): 0\n" for path, text in more.items() if path != "page"},
        "README.md": more.get("page", ""),
    }
    files["setup.py"] = setup_py(entries)
    found = lint_files(files, ["DEP101"]).findings
    return next(each.severity.value for each in found if name in each.message)


TALKS = "from my_pkg.talker import main\n"


def test_what_a_program_imports_beside_a_host() -> None:
    assert level("", sim=HOST + TALKS) == "info"
    assert level("", sim=TALKS + "from my_pkg import more\n", more=HOST) == "info"
    assert level("", sim=HOST + TALKS, name="sensor_msgs") == "warning"
    assert level("", sim=TALKS) == "warning"
    assert level("", sim=TALKS + "def start():\n    import isaaclab\n") == "warning"
    assert level("", ("sim", "talker"), sim=HOST + TALKS) == "warning"
    assert level("", ("sim", "other"), sim=HOST + TALKS, other=TALKS) == "warning"


@pytest.mark.parametrize(
    "page, expected",
    [
        ("conda activate robots\nros2 run my_pkg talker\n", "info"),
        ("conda create -n robots python=3.10\ncolcon build\nrosdep install --from-paths src\n", "info"),
        ("colcon build\nuv run main.py\n", "info"),
        ("python3 -m venv .venv\nros2 launch my_pkg a.launch.py\n", "info"),
        ("python3 -m venv --system-site-packages .venv\nros2 run my_pkg talker\n", "warning"),
        ("source ~/robots/.venv/bin/activate\nros2 launch my_pkg a.launch.py\n", "info"),
        (". venv/bin/activate\ncolcon build\n", "info"),
        ("source install/setup.bash\nros2 launch my_pkg a.launch.py\n", "warning"),
        ("conda activate robots\nros2 run other_pkg talker\n", "warning"),
        ("conda activate robots\npython train.py\n", "warning"),
        ("Do not use it in `conda activate`.\nros2 run my_pkg talker\n", "warning"),
        ("conda deactivate\nros2 run my_pkg talker\n", "warning"),
        ("ros2 run my_pkg talker\n", "warning"),
    ],
)
def test_pages_of_environments(page: str, expected: str) -> None:
    assert level("", ("talker",), page=page) == expected
    assert level("", ("talker",), page=page, name="sensor_msgs") == "warning"


def test_an_environment_that_another_page_opens_to_the_system() -> None:
    files = {**existing_files(BACKDROPS["ament_python"]), "package.xml": manifest(), "my_pkg/a.py": "import serial\n"}
    files["README.md"] = "source .venv/bin/activate\ncolcon build\n"
    (only,) = lint_files(files, ["DEP101"]).findings
    assert only.severity.value == "info"
    files["install.sh"] = "python3 -m venv .venv --system-site-packages\n"
    (only,) = lint_files(files, ["DEP101"]).findings
    assert only.severity.value == "warning"


@pytest.mark.parametrize(
    "text, expected",
    [("import maya.cmds", "info"), ("from maya import mel", "info"), ("import maya", "warning")],
)
def test_names_that_others_have_as_well(text: str, expected: str) -> None:
    assert levels(text) == [expected]
