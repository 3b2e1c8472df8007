"""Launch arguments that lack a declaration, and that every command which people are told gives."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

USE, LATE = '<log message="$(var rate)"/>', '<arg name="rate" default="10"/>'
OTHER = '<arg name="speed" default="1"/><log message="$(var speed)"/>'
NEEDED = manifest("  <exec_depend>ros2launch</exec_depend>\n")


def levels(body: str, comment: str = "", page: str = "") -> list[str]:
    """Return the levels of what is said of the launch arguments of a file, with a comment and a page."""
    launch = f"<!-- {comment} -->\n<launch>\n{body}\n</launch>\n" if comment else f"<launch>\n{body}\n</launch>\n"
    files = {"package.xml": NEEDED, "launch/a.launch.xml": launch, "README.md": page}
    return [each.severity.value for each in lint_files(files, ("LCH008", "LCH016")).findings]


@pytest.mark.parametrize("body", [OTHER + USE, USE + LATE])
@pytest.mark.parametrize(
    "comment, page, level",
    [
        ("", "", "warning"),
        ("ros2 launch my_pkg a.launch.xml rate:=5", "", "info"),
        ("", "    ros2 launch my_pkg a.launch.xml \\\n      rate:=5\n", "info"),
        ("roslaunch my_pkg a.launch rate:=5", "", "info"),
        ("ros2 launch my_pkg a.launch.xml rate:=5", "ros2 launch my_pkg a.launch.xml", "warning"),
        ("ros2 launch my_pkg a.launch.xml rate:=5", "ros2 launch other_pkg a.launch.xml", "info"),
        ("", "ros2 launch other_pkg a.launch.xml rate:=5", "warning"),
        ("roslaunch former_pkg a.launch rate:=5", "", "info"),
        ("ros2 launch my_pkg a.launch.xml speed:=5", "", "warning"),
        ("ros2 launch my_pkg a.launch.xml frame_rate:=5", "", "warning"),
        ("ros2 launch my_pkg b_a.launch.xml rate:=5", "", "warning"),
        ("a.launch.xml rate:=5", "", "warning"),
    ],
)
def test_what_each_told_command_gives(body: str, comment: str, page: str, level: str) -> None:
    assert levels(body, comment, page) == [level]
