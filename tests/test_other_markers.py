"""Packages that are found under another name than the one in package.xml (DEP103, DEP106, DEP112)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, SETUP_CFG, SETUP_PY, manifest
from rospkg_cli.testing import lint_files

MARKED = SETUP_PY.replace("package_name = 'my_pkg'", "package_name = 'our_pkg'")
CFG = SETUP_CFG.replace("my_pkg", "our_pkg")
LAUNCH = """\
<launch>
  <node pkg="our_pkg" exec="talker"/>
  <include file="$(find-pkg-share our_pkg)/launch/b.launch.xml"/>
</launch>
"""
ROBOT = (
    '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">\n'
    '  <xacro:include filename="$(find our_pkg)/urdf/arm.xacro"/>\n</robot>\n'
)
LOOKS = (
    "from ament_index_python.packages import get_package_share_directory\n\n\n"
    "def main():\n    print(get_package_share_directory('our_pkg'))\n"
)
NEEDS = "  <exec_depend>ros2launch</exec_depend>\n  <exec_depend>ament_index_python</exec_depend>\n"
OWN = {
    "package.xml": manifest(NEEDS + "  <exec_depend>xacro</exec_depend>\n"),
    "setup.cfg": CFG,
    "my_pkg/__init__.py": "",
    "my_pkg/talker.py": LOOKS,
    "launch/a.launch.xml": LAUNCH,
    "urdf/r.urdf.xacro": ROBOT,
    "README.md": "    xacro urdf/r.urdf.xacro\n",
}
CODES = ["DEP103", "DEP106", "DEP112", "DEP116", "SET401"]


def told(files: dict[str, str]) -> list[tuple[str, str]]:
    found = lint_files(files, CODES).findings
    return sorted((each.code, each.message.split("`")[1]) for each in found)


def test_what_has_a_marker_of_the_name_is_found() -> None:
    assert told({**OWN, "setup.py": MARKED, "resource/our_pkg": ""}) == [("SET401", "our_pkg")]


@pytest.mark.parametrize(
    "files",
    [
        {"setup.py": SETUP_PY, "resource/my_pkg": ""},
        {"setup.py": MARKED.replace("'resource/' + package_name", "'resource/my_pkg'")},
    ],
)
def test_a_name_without_a_marker_is_not_found(files: dict[str, str]) -> None:
    found = told({**OWN, **files})
    assert ("DEP103", "our_pkg") in found


def test_another_package_that_has_the_name_is_to_be_declared() -> None:
    tree = {f"a/{path}": text for path, text in {**OWN, "setup.py": MARKED, "resource/our_pkg": ""}.items()}
    there = {"b/package.xml": manifest(name="our_pkg"), "b/setup.py": MARKED, "b/resource/our_pkg": ""}
    assert ("DEP103", "our_pkg") in told({**tree, **there})


def test_a_neighbour_is_found_under_its_other_name() -> None:
    tree = {f"a/{path}": text for path, text in {**OWN, "setup.py": MARKED, "resource/our_pkg": ""}.items()}
    user = {"b/package.xml": manifest(NEEDS + "  <exec_depend>my_pkg</exec_depend>\n", name="bringup")}
    user["b/launch/b.launch.xml"] = LAUNCH
    user["b/setup.py"] = SETUP_PY.replace("'my_pkg'", "'bringup'")
    assert told({**tree, **user}) == [("SET401", "our_pkg")]


def test_the_name_of_project_is_that_of_no_package() -> None:
    """CMake stops there (CMK001), and the launch file is to be changed as well."""
    cmake = CMAKE.replace("project(my_pkg)", "project(robot_arm)")
    files = {
        "CMakeLists.txt": cmake,
        "package.xml": manifest(NEEDS, "ament_cmake"),
        "launch/a.launch.xml": LAUNCH.replace("our_pkg", "robot_arm"),
    }
    (finding,) = lint_files(files, ["DEP103"]).findings
    assert "did you mean `my_pkg`?" in finding.message
