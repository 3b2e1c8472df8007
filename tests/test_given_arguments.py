"""Nobody misses a file that is only a default where all that starts the launch file gives another one (LCH003)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

PACKAGE = {
    "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
    "CMakeLists.txt": CMAKE.replace(
        "ament_package", "install(DIRECTORY launch maps DESTINATION share/${PROJECT_NAME})\nament_package"
    ),
    "maps/hall.pgm": "P5",
    "launch/nav.launch.xml": """\
<launch>
  <arg name="map" default="$(find-pkg-share my_pkg)/maps/lab.yaml"/>
  <node pkg="nav2_map_server" exec="map_server"><param name="yaml_filename" value="$(var map)"/></node>
</launch>
""",
}
INCLUDES = """\
<launch>
  <include file="$(find-pkg-share my_pkg)/launch/nav.launch.xml">{}</include>
</launch>
"""
GIVES = '<arg name="map" value="/maps/a.yaml"/>'


def told(**more: str) -> list[tuple[str, str]]:
    files = {**PACKAGE, **{name.replace("__", "/").replace("_DOT_", "."): text for name, text in more.items()}}
    found = lint_files(files, ["LCH003"]).findings
    return [(each.severity.value, each.message.partition("another one is given")[2]) for each in found]


LOUD = [("warning", "; add it, or correct the path")]


@pytest.mark.parametrize(
    ("page", "is_given"),
    [
        ("ros2 launch my_pkg nav.launch.xml map:=$HOME/lab.yaml", True),
        ("ros2 launch my_pkg nav.launch.xml map:=a.yaml\n\n    ros2 launch my_pkg nav.launch.xml", False),
        ("ros2 launch my_pkg nav.launch.xml other_map:=a.yaml", False),
        ("ros2 launch my_pkg all.launch.xml map:=a.yaml", False),
    ],
)
def test_commands_of_pages_may_always_give_another_file(page: str, is_given: bool) -> None:
    why = ", where no `map:=` is given, as it is in every command that documentation and comments show"
    expected = [("info", f"{why}; add it, or correct the path")] if is_given else LOUD
    assert told(README_DOT_md=f"# Navigation\n\n    {page}\n") == expected


def test_files_that_include_it_may_always_give_another_file() -> None:
    why = ", where no `map:=` is given, which each launch file gives that includes this one"
    mild = [("info", f"{why}; add it, or correct the path")]
    assert told(launch__all_DOT_launch_DOT_xml=INCLUDES.format(GIVES)) == mild
    assert told(launch__all_DOT_launch_DOT_xml=INCLUDES.format("")) == LOUD
    both = {"launch__b_DOT_launch_DOT_xml": INCLUDES.format("")}
    assert told(launch__all_DOT_launch_DOT_xml=INCLUDES.format(GIVES), **both) == LOUD
    page = {"README_DOT_md": "    ros2 launch my_pkg nav.launch.xml\n"}
    assert told(launch__all_DOT_launch_DOT_xml=INCLUDES.format(GIVES), **page) == LOUD
