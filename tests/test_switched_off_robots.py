"""What xacro leaves out for the defaults of a robot need not be installed: an info (DEP106)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.testing import lint_files

ROBOT = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">
  <xacro:arg name="sim" default="none"/>
  <xacro:arg name="arm" default="false"/>
  <xacro:arg name="open"/>
  <xacro:property name="lidar" value="false"/>
  <xacro:property name="mode" value="$(arg sim)"/>
  <xacro:property name="twice" value="false"/>
  <xacro:property name="twice" value="true"/>
  <link name="base"/>
  {}
</robot>
"""
INCLUDE = '<xacro:include filename="$(find ur_description)/urdf/ur_macro.xacro"/>'


@pytest.mark.parametrize(
    ("around", "level"),
    [
        ("{}", "warning"),
        ('<xacro:if value="$(arg arm)">{}</xacro:if>', "info"),
        ('<xacro:unless value="$(arg arm)">{}</xacro:unless>', "warning"),
        ('<xacro:if value="$(arg open)">{}</xacro:if>', "warning"),
        ("<xacro:if value=\"${'$(arg sim)' == 'gz'}\">{}</xacro:if>", "info"),
        ("<xacro:if value=\"${'$(arg sim)' == 'none'}\">{}</xacro:if>", "warning"),
        ('<xacro:if value="${lidar}">{}</xacro:if>', "info"),
        ('<xacro:if value="${twice}">{}</xacro:if>', "warning"),
        ("<xacro:if value=\"${mode in ('gz', 'isaac')}\">{}</xacro:if>", "info"),
        ("<xacro:if value=\"${not lidar and mode == 'none'}\">{}</xacro:if>", "warning"),
        ("<xacro:if value=\"${xacro.arg('arm')}\">{}</xacro:if>", "info"),
        ('<xacro:if value="${len(mode) - 4}">{}</xacro:if>', "info"),
        ('<xacro:macro name="add" params="lidar">{}</xacro:macro>', "info"),
        ('<xacro:macro name="add" params="lidar">{}</xacro:macro><xacro:add lidar="true"/>', "warning"),
        (
            '<xacro:macro name="add" params="lidar"><xacro:if value="${lidar}">{}</xacro:if></xacro:macro>'
            '<xacro:add lidar="true"/>',
            "warning",
        ),
    ],
)
def test_conditions(around: str, level: str) -> None:
    package = existing_files(BACKDROPS["ament_python"])
    text = ROBOT.format(around.replace("{}", INCLUDE))
    files = {"urdf/robot.urdf.xacro": text, "README.md": "    xacro urdf/robot.urdf.xacro > robot.urdf\n"}
    (only,) = lint_files({**package, "package.xml": manifest(), **files}, ["DEP106"]).findings
    assert only.severity.value == level
