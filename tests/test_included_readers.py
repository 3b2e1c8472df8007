"""Whether a launch file that another one includes may read the parameter files that this gives to its nodes."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

INSTALL = "install(DIRECTORY launch config DESTINATION share/${PROJECT_NAME})\nament_package"
START = """\
<launch>
  <arg name="config" default="$(find-pkg-share bringup)/config/robot.yaml"/>
  <node pkg="driver" exec="driver" name="driver"><param from="$(var config)"/></node>
  <include file="$(find-pkg-share {})/launch/{}">{}</include>
</launch>
"""
PLAIN = '<launch><node pkg="p" exec="e"/></launch>\n'


def told(included: str, package: str = "shown", passed: str = "", name: str = "show.launch.xml") -> bool:
    files = {"bringup/config/robot.yaml": "driver_one:\n  ros__parameters:\n    rate: 1.0\n"}
    files["bringup/launch/start.launch.xml"] = START.format(package, name, passed)
    files["shown/launch/show.launch.xml"] = included
    files["shown/launch/start.launch.xml"] = PLAIN
    files["shown/launch/more.launch.xml"] = '<launch><log message="$(var config)"/></launch>\n'
    for each in ("bringup", "shown"):
        files[f"{each}/package.xml"] = manifest("", "ament_cmake", each)
        files[f"{each}/CMakeLists.txt"] = CMAKE.replace("my_pkg", each).replace("ament_package", INSTALL)
    return bool(lint_files(files, ["PRM003"]).findings)


@pytest.mark.parametrize(
    "included, is_told",
    [
        (PLAIN, True),
        ('<launch><arg name="other" default="x"/><log message="$(var other)"/></launch>', True),
        ('<launch><log message="$(var config)"/></launch>', False),
        ('<launch><arg name="config" default="x"/></launch>', False),
        ('<launch><include file="$(find-pkg-share shown)/launch/start.launch.xml"/></launch>', False),
        ('<launch><include file="$(find-pkg-share shown)/launch/more.launch.xml"/></launch>', False),
        ('<launch><include file="$(find-pkg-share shown)/launch/$(env X)"/></launch>', False),
    ],
)
def test_what_an_included_file_reads(included: str, is_told: bool) -> None:
    assert told(included) is is_told


def test_an_included_file_that_is_not_here() -> None:
    assert not told(PLAIN, "elsewhere")
    assert not told(PLAIN, name="other.launch.xml")


def test_a_file_of_the_same_name_in_another_package() -> None:
    assert told(PLAIN, name="start.launch.xml")


@pytest.mark.parametrize("value, is_told", [("x", True), ("$(var config)", False), ("config/robot.yaml", False)])
def test_what_is_passed_on(value: str, is_told: bool) -> None:
    assert told(PLAIN, passed=f'<arg name="model" value="{value}"/>') is is_told
