"""Packages that parameter files and MoveIt's builder look for (DEP103, DEP106)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

INSTALLS = "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\n"
NEEDS = "".join(f"  <exec_depend>{name}</exec_depend>\n" for name in ("moveit_configs_utils", "ros2launch"))
LAUNCH = """\
from launch import LaunchDescription
from moveit_configs_utils import MoveItConfigsBuilder


def generate_launch_description():
    {}
    return LaunchDescription()
"""


def told(files: dict[str, str], depends: str = "", installs: str = INSTALLS) -> list[tuple[str, str, str]]:
    written = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{installs}ament_package()"),
        "package.xml": manifest(NEEDS + depends, "ament_cmake"),
        **files,
    }
    found = lint_files(written, ["DEP103", "DEP106"]).findings
    return [(each.code, each.severity.value, each.message.split("`")[1]) for each in found]


@pytest.mark.parametrize(
    "line, name",
    [
        ("MoveItConfigsBuilder('panda', package_name='moveit_resources')", "moveit_resources"),
        ("MoveItConfigsBuilder('moveit_resources_panda').to_moveit_configs()", "moveit_resources_panda_moveit_config"),
        ("MoveItConfigsBuilder(robot_name='moveit_resources_panda')", "moveit_resources_panda_moveit_config"),
    ],
)
def test_the_builder_reads_a_package(line: str, name: str) -> None:
    files = {"launch/a.launch.py": LAUNCH.format(line)}
    assert [found for _, _, found in told(files)] == [name]
    assert told(files, f"  <exec_depend>{name}</exec_depend>\n") == []


def test_other_builders_and_names() -> None:
    for line in ("MoveItConfigsBuilder(name)", "Builder('panda')", "MoveItConfigsBuilder('my', package_name='my_pkg')"):
        assert told({"launch/a.launch.py": LAUNCH.format(line)}) == []


def test_parameter_files_look_for_packages() -> None:
    text = 'a:\n  ros__parameters:\n    tree: "$(find-pkg-share nav2_bt_navigator)/tree.xml"\n'
    assert told({"config/a.yaml": text}) == [("DEP106", "info", "nav2_bt_navigator")]
    assert told({"config/a.yaml": text}, "  <exec_depend>nav2_bt_navigator</exec_depend>\n") == []
    assert told({"config/a.yaml": text}, installs=INSTALLS.replace("config ", "")) == []
    assert told({"config/a.yaml": text.replace("    tree", "    # tree")}) == []
    assert told({"config/a.yaml": text.replace("nav2_bt_navigator", "nobodys_package")}) == []
    assert told({"test/a.yaml": text}) == []
