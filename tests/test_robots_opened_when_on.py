"""Robots that only actions of launch files open which are off by default, and what xacro passes over in macros."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files
from rospkg_cli.testing import lint_files

INSTALLS = CMAKE.replace(
    "ament_package", "install(DIRECTORY launch meshes urdf DESTINATION share/${PROJECT_NAME})\nament_package"
)
LAUNCH = """\
<launch>
  <arg name="model" default="{}"/>
  <node pkg="robot_state_publisher" exec="robot_state_publisher" if="$(var model)">
    <param name="robot_description" value="$(command 'xacro $(find-pkg-share my_pkg)/urdf/robot.urdf.xacro')"/>
  </node>
</launch>
"""
ROBOT = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">
  {}
  <link name="base"/>
</robot>
"""
INCLUDE = '<xacro:include filename="$(find my_pkg)/urdf/gripper.xacro"/>'
TWICE = '<link name="base"/>'
MACRO = """\
<xacro:macro name="arm" params="prefix tool:=none">
    <link name="${{prefix}}arm">
      <xacro:if value="${{tool == 'gripper'}}">
        <visual><geometry><mesh filename="package://my_pkg/meshes/gripper.stl"/></geometry></visual>
      </xacro:if>
    </link>
  </xacro:macro>
  <xacro:arm prefix=""{}/>"""


def level(robot: str, default: str = "true", more: dict[str, str] | None = None) -> tuple[str, str]:
    files = {**existing_files(BACKDROPS["ament_cmake"]), "CMakeLists.txt": INSTALLS, "meshes/arm.stl": "solid arm\n"}
    files |= {"urdf/robot.urdf.xacro": ROBOT.format(robot), "launch/show.launch.xml": LAUNCH.format(default)}
    (found,) = lint_files({**files, **(more or {})}, ["URD001", "URD002"]).findings
    return found.code, found.severity.value


@pytest.mark.parametrize(("robot", "code"), [(INCLUDE, "URD002"), (TWICE, "URD001")])
def test_who_opens_a_robot(robot: str, code: str) -> None:
    assert level(robot) == (code, "error")
    assert level(robot, "false") == (code, "info")
    told = {"README.md": "`ros2 launch my_pkg show.launch.xml model:=true`\n"}
    assert level(robot, "false", told) == (code, "error")
    typed = {"README.md": "`xacro urdf/robot.urdf.xacro`\n"}
    assert level(robot, "false", typed)[1] != level(robot, "false")[1] or code == "URD001"
    other = {"launch/all.launch.xml": LAUNCH.format("true")}
    assert level(robot, "false", other) == (code, "error")


@pytest.mark.parametrize(
    ("given", "expected"), [("", "info"), (' tool="none"', "info"), (' tool="gripper"', "warning")]
)
def test_what_a_macro_is_given(given: str, expected: str) -> None:
    assert level(MACRO.format(given)) == ("URD002", expected)
