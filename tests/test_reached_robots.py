"""Files that robots include under conditions, and arguments that nothing reads: there a missing file is less bad."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.finding import Finding
from rospkg_cli.testing import lint_files

HEAD = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"{}>'
INSTALL = CMAKE.replace("ament_package", "install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\nament_package")
TOP = HEAD.format(' name="r"')
ARG = '<xacro:arg name="sim" default="{}"/>'
INCLUDE = '<xacro:include filename="$(find my_pkg)/urdf/part.xacro"/>'
MESH = '<mesh filename="package://my_pkg/urdf/wheel.stl"/>'
LACKS = '<xacro:include filename="$(find my_pkg)/urdf/wheel.xacro"/>'
LAUNCH = "<launch>\n  <arg name='m' default='robot.xacro'/>\n</launch>\n"
WHERE = ", where the condition around its include holds; add it"
GIVEN = '<xacro:arg name="mesh" default="$(find my_pkg)/urdf/wheel.stl"/>'
UNREAD = ", as soon as something reads `$(arg mesh)`; add it"


def lint(robot: str, part: str = LACKS, **more: str) -> Finding:
    """Return the one finding in a robot, a part of it, and other files by their names."""
    files = {
        "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": INSTALL,
        "launch/a.launch.xml": LAUNCH,
        "urdf/robot.xacro": f"{TOP}{robot}</robot>\n",
        "urdf/part.xacro": f"{HEAD.format('')}{part}</robot>\n",
        **{f"urdf/{name}.xacro": f"{HEAD.format('')}{text}</robot>\n" for name, text in more.items()},
    }
    (finding,) = lint_files(files, ["URD002"]).findings
    return finding


@pytest.mark.parametrize(
    "robot, level",
    [
        (INCLUDE, "error"),
        (f'{ARG.format("false")}<xacro:if value="$(arg sim)">{INCLUDE}</xacro:if>', "info"),
        (f'{ARG.format("true")}<xacro:if value="$(arg sim)">{INCLUDE}</xacro:if>', "error"),
        (f"{ARG.format('gz')}<xacro:if value=\"${{'$(arg sim)' == 'gz'}}\">{INCLUDE}</xacro:if>", "error"),
        (f"{ARG.format('gz')}<xacro:if value=\"${{'$(arg sim)' == 'mujoco'}}\">{INCLUDE}</xacro:if>", "warning"),
        (f'{ARG.format("true")}<xacro:unless value="$(arg sim)">{INCLUDE}</xacro:unless>', "info"),
        (f'{ARG.format("false")}<xacro:unless value="$(arg sim)">{INCLUDE}</xacro:unless>', "error"),
        (
            f'{ARG.format("gz")}<xacro:property name="s" value="$(arg sim)"/>'
            f"<xacro:if value=\"${{s == 'gz'}}\">{INCLUDE}</xacro:if>",
            "error",
        ),
        (
            f'{ARG.format("0")}<xacro:property name="s" value="$(arg sim)"/>'
            f'<xacro:if value="${{1 &lt;= s}}">{INCLUDE}</xacro:if>',
            "warning",
        ),
        (
            f'{ARG.format("1")}<xacro:property name="s" value="$(arg sim)"/>'
            f'<xacro:if value="${{1 &lt;= s}}">{INCLUDE}</xacro:if>',
            "error",
        ),
        (
            f'{ARG.format("none")}<xacro:property name="s" value="$(arg sim)"/>'
            f"<xacro:if value=\"${{s == 'gz'}}\">{INCLUDE}</xacro:if>",
            "warning",
        ),
        (f'<xacro:arg name="sim"/><xacro:if value="$(arg sim)">{INCLUDE}</xacro:if>', "warning"),
        (f'{ARG.format("false")}<xacro:if value="$(arg sim)">{INCLUDE}</xacro:if>{INCLUDE}', "error"),
        (f'{ARG.format("true")}{ARG.format("false")}<xacro:if value="$(arg sim)">{INCLUDE}</xacro:if>', "error"),
    ],
)
def test_a_part_that_is_off_by_default_is_missed_by_some(robot: str, level: str) -> None:
    found = lint(robot)
    assert (found.severity.value, WHERE in found.message) == (level, level == "warning")
    assert found.location.path == "urdf/part.xacro"


def test_a_part_of_a_part_that_is_off_is_off() -> None:
    between = INCLUDE.replace("part", "between")
    robot = f'{ARG.format("false")}<xacro:if value="$(arg sim)">{between}</xacro:if>'
    assert lint(robot, between=INCLUDE).severity.value == "warning"
    assert lint(between, between=INCLUDE).severity.value == "error"


def test_a_part_that_a_robot_only_names_is_opened_by_nothing() -> None:
    argument = "<xacro:arg name='m' default='part.xacro'/>"
    found = lint('<link name="a"/>', other=argument)
    assert (found.severity.value, WHERE in found.message) == ("info", False)
    found = lint(f'{argument}<xacro:include filename="$(arg m)"/>')
    assert found.severity.value != "info"


@pytest.mark.parametrize(
    "robot, part, level",
    [
        (GIVEN, "", "info"),
        (f'{GIVEN}<a b="$(arg mesh)"/>', "", "warning"),
        (f"{GIVEN}{INCLUDE}", "", "info"),
        (f"{GIVEN}{INCLUDE}", '<a b="$(arg mesh)"/>', "warning"),
        (f"{GIVEN}{INCLUDE}", '<a b="$(arg  mesh)"/>', "warning"),
        (f"{GIVEN}{INCLUDE}", '<a b="$(arg meshes)"/>', "info"),
        (f"{GIVEN}{INCLUDE}", "<a b=\"${xacro.arg('mesh')}\"/>", "warning"),
        (f'{GIVEN}<xacro:include filename="$(find other)/urdf/a.xacro"/>', "", "warning"),
        (f'{GIVEN}<xacro:include filename="$(arg other)"/>', "", "warning"),
        (f"{GIVEN}<xacro:other/>", "", "info"),
    ],
)
def test_a_default_that_nothing_reads_is_an_info(robot: str, part: str, level: str) -> None:
    found = lint(robot, part)
    assert (found.severity.value, UNREAD in found.message) == (level, level == "info")


def test_another_package_may_read_the_argument() -> None:
    def levels(text: str) -> list[str]:
        robot = f'{GIVEN}<xacro:include filename="$(find other)/urdf/a.xacro"/>'
        files = {
            "my_pkg/package.xml": manifest("  <exec_depend>other</exec_depend>\n", "ament_cmake"),
            "my_pkg/CMakeLists.txt": INSTALL,
            "my_pkg/launch/a.launch.xml": LAUNCH,
            "my_pkg/urdf/robot.xacro": f"{TOP}{robot}</robot>\n",
            "other/package.xml": manifest("", "ament_cmake", "other"),
            "other/CMakeLists.txt": INSTALL.replace("my_pkg", "other"),
            "other/urdf/a.xacro": f"{HEAD.format('')}{text}</robot>\n",
        }
        return [each.severity.value for each in lint_files(files, ["URD002"]).findings]

    assert levels("") == ["info"]
    assert levels('<a b="$(arg mesh)"/>') == ["warning"]


@pytest.mark.parametrize("name", ["left", "1"])
def test_a_word_in_other_files_does_not_open_a_robot(name: str) -> None:
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": INSTALL,
        "config/a.yaml": f"arm:\n  ros__parameters:\n    robot: {name}\n",
        "launch/b.launch.py": "PATH = share + '/config/a.yaml'\n",
        f"urdf/{name}.xacro": f"{TOP}{MESH}</robot>\n",
    }
    (finding,) = lint_files(files, ["URD002"]).findings
    assert finding.severity.value == "info"
