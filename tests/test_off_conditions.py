"""What a robot lacks under a condition of xacro that nothing here makes true (URD002)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files
from rospkg_cli.testing import lint_files

XACRO = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">\n  {}\n  <link name="base"/>\n</robot>\n'
LACKS = '<xacro:include filename="gone.xacro"/>'
OFF = '<xacro:arg name="lidar" default="false"/>\n  '
OPENS = """\
def generate_launch_description():
    xacro.process_file(get_package_share_directory('my_pkg') + '/urdf/r.urdf.xacro'{})
"""
FILES = {
    **existing_files(BACKDROPS["ament_cmake"]),
    "CMakeLists.txt": CMAKE.replace(
        "ament_package", "install(DIRECTORY launch urdf DESTINATION share/${PROJECT_NAME})\nament_package"
    ),
    "launch/show.launch.py": OPENS.format(""),
}
GIVES = {"launch/show.launch.py": OPENS.format(", mappings={'lidar': 'true'}")}


def level(body: str, **more: str) -> str:
    files = {**FILES, "urdf/r.urdf.xacro": XACRO.format(body), **more}
    (finding,) = lint_files(files, ["URD002"]).findings
    assert ("which nothing here makes true" in finding.message) is (finding.severity.value == "info")
    return finding.severity.value


@pytest.mark.parametrize(
    "body, expected",
    [
        (LACKS, "error"),
        (f'<xacro:if value="false">{LACKS}</xacro:if>', "info"),
        (f'<xacro:if value="0">{LACKS}</xacro:if>', "info"),
        (f'<xacro:unless value="true">{LACKS}</xacro:unless>', "info"),
        (f'<xacro:if value="true">{LACKS}</xacro:if>', "warning"),
        (f'<xacro:if value="${{1 == 1}}">{LACKS}</xacro:if>', "warning"),
        (f'{OFF}<xacro:if value="$(arg lidar)">{LACKS}</xacro:if>', "info"),
        (f'{OFF}<xacro:unless value="$(arg lidar)">{LACKS}</xacro:unless>', "warning"),
        (f'{OFF}<xacro:if value="$(arg lidar2)">{LACKS}</xacro:if>', "warning"),
        (f'{OFF.replace("false", "true")}<xacro:if value="$(arg lidar)">{LACKS}</xacro:if>', "warning"),
        (f'<xacro:property name="on" value="0"/><xacro:if value="${{on}}">{LACKS}</xacro:if>', "info"),
        (
            '<xacro:property name="on" value="0"/><xacro:property name="on" value="1"/>'
            f'<xacro:if value="${{on}}">{LACKS}</xacro:if>',
            "warning",
        ),
        (
            f'{OFF}<xacro:property name="on" value="$(arg lidar)"/><xacro:if value="${{on}}">{LACKS}</xacro:if>',
            "info",
        ),
    ],
)
def test_a_condition_is_off(body: str, expected: str) -> None:
    assert level(body) == expected


def test_who_gives_the_argument_meets_it() -> None:
    body = f'{OFF}<xacro:if value="$(arg lidar)">{LACKS}</xacro:if>'
    assert level(body, **GIVES) == "warning"
    assert level(body, **{"README.md": "    xacro urdf/r.urdf.xacro lidar:=true\n"}) == "warning"
    assert level(body, **{"test/a.py": "'lidar'\n"}) == "info"


def test_a_parameter_of_a_macro_hides_a_property() -> None:
    macro = '<xacro:macro name="m" params="on"><xacro:if value="${on}">' + LACKS + "</xacro:if></xacro:macro>"
    body = f'<xacro:property name="on" value="0"/>{macro}<xacro:m on="1"/>'
    assert level(body) == "warning"


def test_a_file_that_is_only_included_under_such_a_condition() -> None:
    part = {"urdf/part.xacro": XACRO.format(LACKS).replace(' name="r"', "")}
    include = '<xacro:include filename="$(find my_pkg)/urdf/part.xacro"/>'
    assert level(f'{OFF}<xacro:if value="$(arg lidar)">{include}</xacro:if>', **part) == "info"
    assert level(f'{OFF}<xacro:if value="$(arg lidar)">{include}</xacro:if>', **part, **GIVES) == "warning"
    assert level(include, **part) == "error"
