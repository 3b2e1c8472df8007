"""What no robot of a package comes to with the values that its arguments have need not be installed (DEP106)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.testing import lint_files

PYTHON = existing_files(BACKDROPS["ament_python"])
ROBOT = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">
  <xacro:arg name="gripper" default="{default}"/>
  <xacro:include filename="parts.xacro"/>
  <xacro:parts prefix="" {given}/>
</robot>
"""
PARTS = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="parts" params="prefix gripper:=false">
    <link name="base"/>
    <xacro:if value="${{gripper}}">{}</xacro:if>
  </xacro:macro>
</robot>
"""
INCLUDE = '<xacro:include filename="$(find ur_description)/urdf/ur_macro.xacro"/>'
README = {"README.md": "    xacro urdf/robot.urdf.xacro > robot.urdf\n"}
HANDS = 'gripper="$(arg gripper)"'


def started(words: str, declared: str = "") -> str:
    return (
        "from launch import LaunchDescription\nfrom launch.substitutions import Command\n\n\n"
        "def generate_launch_description():\n"
        f"    made = Command(['xacro ', 'robot.urdf.xacro', {words}])\n"
        f"    return LaunchDescription([{declared} *made.command])\n"
    )


def told(files: dict[str, str]) -> list[tuple[str, str]]:
    package = {**PYTHON, "package.xml": manifest("  <exec_depend>xacro</exec_depend>\n"), **files}
    return [(each.severity.value, each.message) for each in lint_files(package, ["DEP106"]).findings]


@pytest.mark.parametrize(
    ("default", "given", "more", "level"),
    [
        ("false", HANDS, {}, "info"),
        ("true", HANDS, {}, "warning"),
        ("true", "", {}, "info"),
        ("false", 'gripper="true"', {}, "warning"),
        ("false", HANDS, {"launch/a.launch.py": started("' gripper:=false'")}, "info"),
        ("false", HANDS, {"launch/a.launch.py": started("' gripper:=true'")}, "warning"),
        ("true", HANDS, {"launch/a.launch.py": started("' gripper:=false'")}, "info"),
        ("false", HANDS, {"launch/a.launch.py": started("' gripper:=', value")}, "warning"),
        ("false", HANDS, {"README.md": README["README.md"] + "    xacro robot.urdf.xacro gripper:=true\n"}, "warning"),
        ("false", HANDS, {"README.md": README["README.md"] + "`gripper` adds one.\n"}, "info"),
        (
            "false",
            HANDS,
            {
                "launch/a.launch.py": started(
                    "' gripper:=', value", "DeclareLaunchArgument('gripper', default_value='false'),"
                )
            },
            "info",
        ),
    ],
)
def test_conditions_in_macros(default: str, given: str, more: dict[str, str], level: str) -> None:
    robot = ROBOT.format(default=default, given=given)
    files = {"urdf/robot.urdf.xacro": robot, "urdf/parts.xacro": PARTS.format(INCLUDE), **README, **more}
    assert [each[0] for each in told(files)] == [level]


@pytest.mark.parametrize(
    ("given", "more", "level"),
    [
        ("$(optenv GRIPPER false)", "", "info"),
        ("$(optenv GRIPPER true)", "", "warning"),
        ("$(optenv GRIPPER false)", "    export GRIPPER=true\n", "warning"),
        ("$(env GRIPPER)", "", "warning"),
    ],
)
def test_variables_of_the_environment(given: str, more: str, level: str) -> None:
    robot = ROBOT.format(default="false", given=f'gripper="{given}"')
    files = {"urdf/robot.urdf.xacro": robot, "urdf/parts.xacro": PARTS.format(INCLUDE)}
    assert [each[0] for each in told({**files, "README.md": README["README.md"] + more})] == [level]


def test_a_macro_that_others_may_call() -> None:
    """A robot that nothing here expands may give another value."""
    robot = ROBOT.format(default="false", given=HANDS)
    other = '<part xmlns:xacro="x"><xacro:parts prefix="a" gripper="true"/></part>'
    files = {"urdf/robot.urdf.xacro": robot, "urdf/parts.xacro": PARTS.format(INCLUDE), "urdf/b.xacro": other, **README}
    assert [each[0] for each in told(files)] == ["warning"]


ARGUED = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">
  <xacro:arg name="values" default="$(find ur_description)/config/a.yaml"/>
  <xacro:property name="all" value="${xacro.load_yaml('$(arg values)')}"/>
  <link name="${all['base']}"/>
</robot>
"""
GIVES = started("' values:=/tmp/a.yaml'")


@pytest.mark.parametrize(
    ("launches", "level"),
    [
        ({"a": GIVES}, "info"),
        ({"a": GIVES, "b": started("''")}, "warning"),
        ({"a": GIVES, "b": started("''").replace("robot.urdf.xacro", "robot.urdf")}, "info"),
        ({"a": "import xacro\nS = {'values': 1}\nxacro.process_file('robot.urdf.xacro', mappings=S)\n"}, "info"),
        ({"a": "import xacro\nxacro.process_file('robot.urdf.xacro', mappings={'values': V})\n"}, "info"),
    ],
)
def test_defaults_that_launch_files_replace(launches: dict[str, str], level: str) -> None:
    files = {f"launch/{name}.launch.py": text for name, text in launches.items()}
    found = told({"urdf/robot.urdf.xacro": ARGUED, **files, **README})
    assert [each[0] for each in found] == [level]
    assert ("gives `values`" in found[0][1]) == (level == "info")


def test_a_default_that_another_file_gives_first() -> None:
    first = ROBOT.format(default="no", given="").replace("gripper", "values")
    files = {"urdf/robot.urdf.xacro": first, "urdf/parts.xacro": ARGUED.replace(' name="robot"', ""), **README}
    assert [(level, "gives `values` its default" in text) for level, text in told(files)] == [("info", True)]


@pytest.mark.parametrize(
    ("attributes", "read", "level"),
    [
        ("", "", "info"),
        ("", "${meshes}/a.stl", "warning"),
        (' lazy_eval="false"', "", "warning"),
        (' scope="global"', "", "warning"),
    ],
)
def test_properties_that_nothing_reads(attributes: str, read: str, level: str) -> None:
    robot = (
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">\n'
        f'  <xacro:property name="meshes" value="$(find ur_description)/meshes"{attributes}/>\n'
        f'  <link name="base"><visual><geometry><mesh filename="{read}"/></geometry></visual></link>\n</robot>\n'
    )
    assert [each[0] for each in told({"urdf/robot.urdf.xacro": robot, **README})] == [level]
