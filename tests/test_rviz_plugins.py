"""PLG003 in RViz configs: what is near is of the same kind, and a panel that is lacking costs nothing else."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

CONFIG = """\
Panels:
  - Class: {Panel}
    Name: One
Visualization Manager:
  Displays:
    - Class: rviz_common/Group
      Displays:
        - Class: {Display}
  Tools:
    - Class: {Tool}
  Views:
    Current:
      Class: {ViewController}
"""
RIGHT = {
    "Panel": "nav2_rviz_plugins/Navigation 2",
    "Display": "rviz_default_plugins/Grid",
    "Tool": "nav2_rviz_plugins/GoalTool",
    "ViewController": "rviz_default_plugins/Orbit",
}
FILES = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": CMAKE}


def said(kind: str, name: str, more: dict[str, str] | None = None) -> list[tuple[str, str]]:
    files = {**FILES, **(more or {}), "rviz/a.rviz": CONFIG.format(**{**RIGHT, kind: name})}
    found = lint_files(files, ["PLG003"]).findings
    return [(each.severity.value, each.fix.title if each.fix else "") for each in found]


def test_names_that_are_right() -> None:
    assert said("Panel", RIGHT["Panel"]) == []


@pytest.mark.parametrize(
    ("kind", "name", "found"),
    [
        ("Panel", "moveit_ros_visualization/MotionPlanning", [("info", "")]),
        ("Display", "moveit_ros_visualization/RobotState", [("warning", "write `moveit_rviz_plugin/RobotState`")]),
        ("Panel", "nav2_rviz_plugins/Selectr", [("info", "write `nav2_rviz_plugins/Selector`")]),
        ("Tool", "nav2_rviz_plugins/GoalTol", [("warning", "write `nav2_rviz_plugins/GoalTool`")]),
        ("Display", "nav2_rviz_plugins/GoalTol", [("info", "")]),
    ],
)  # fmt: skip
def test_what_is_near_is_of_the_same_kind(kind: str, name: str, found: list[tuple[str, str]]) -> None:
    assert said(kind, name) == found


@pytest.mark.parametrize(("base", "fix"), [("Panel", "write `my_pkg/Knobs`"), ("Display", "")])
def test_plugins_of_the_workspace_are_of_a_kind_too(base: str, fix: str) -> None:
    lines = (
        "find_package(rviz_common REQUIRED)\nadd_library(knobs SHARED src/knobs.cpp)\n"
        "install(TARGETS knobs DESTINATION lib)\n"
        "pluginlib_export_plugin_description_file(rviz_common plugins.xml)\nament_package"
    )
    more = {
        "CMakeLists.txt": CMAKE.replace("ament_package", lines),
        "plugins.xml": '<library path="knobs">\n  <class name="my_pkg/Knobs" type="my_pkg::Knobs" '
        f'base_class_type="rviz_common::{base}"/>\n</library>\n',
        "src/knobs.cpp": f"PLUGINLIB_EXPORT_CLASS(my_pkg::Knobs, rviz_common::{base})\n",
    }
    assert said("Panel", "my_pkg/Knob", more) == [("info", fix)]
