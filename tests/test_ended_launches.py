"""What launch would meet at its visit is an info where Python stops before it has the description."""

from __future__ import annotations

import pytest

from rospkg_cli.example import SETUP_PY_FOR_ALL, manifest
from rospkg_cli.testing import lint_files

FILE = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch_ros.actions import Node
{above}

def generate_launch_description():
    talker = Node(package='my_pkg', executable='talkr')
    {stop}
    return LaunchDescription([talker])
"""
FILES = {"package.xml": manifest("  <exec_depend>launch_ros</exec_depend>\n"), "setup.py": SETUP_PY_FOR_ALL}


def levels(stop: str, above: str = "", **files: str) -> dict[str, tuple[str, str]]:
    text = FILE.format(stop=stop, above=above)
    written = {**FILES, "my_pkg/__init__.py": "", "launch/a.launch.py": text, **files}
    findings = lint_files(written, ["LCH002", "LCH013", "LCH014"]).findings
    return {each.code: (each.severity.value, each.message) for each in findings}


@pytest.mark.parametrize(
    "stop, above",
    [
        ("other = Node(package='my_pkg', condition=IfCondition('true'))", ""),
        ("", "from launch.substitution import LaunchConfiguration\n"),
    ],
)
def test_nobody_visits_what_python_never_returns(stop: str, above: str) -> None:
    found = levels(stop, above)
    ((level, message),) = [found[code] for code in found if code == "LCH002"]
    assert level == "info"
    assert message.endswith("; the launch ends before, at another line")
    assert {level for code, (level, _) in found.items() if code != "LCH002"} == {"error"}


@pytest.mark.parametrize(
    "stop",
    [
        "",
        "mode = DeclareLaunchArgument()",
        "if talker.name:\n        other = IfCondition('true')",
        "late = OpaqueFunction(function=lambda context: [IfCondition('true')])",
        "try:\n        other = IfCondition('true')\n    except NameError:\n        pass",
    ],
)
def test_what_may_be_visited_keeps_its_level(stop: str) -> None:
    assert levels(stop)["LCH002"][0] == "error"


def paths(stop: str, **files: str) -> list[tuple[str, bool]]:
    """Return the level of a path in a home that a launch file has before a place, and whether it tells of the end."""
    text = FILE.format(stop=stop, above="").replace("'talkr'", "'talker', arguments=['/home/ada/ws/src/my_pkg/a.txt']")
    written = {**FILES, "a.txt": "", "my_pkg/__init__.py": "", "launch/a.launch.py": text, **files}
    found = lint_files(written, ["DEP118", "LCH013"]).findings
    told = [each for each in found if each.code == "DEP118"]
    return [(each.severity.value, each.message.endswith("; the launch ends before, at another line")) for each in told]


def test_a_personal_path_that_no_launch_comes_to() -> None:
    stop, other = "other = IfCondition('true')", "A = '/home/ada/ws/src/my_pkg/a.txt'\nprint(A)\n"
    assert paths("") == [("warning", False)]
    assert paths(stop) == [("info", True)]
    assert paths(stop, **{"my_pkg/words.py": other}) == [("warning", False)]
