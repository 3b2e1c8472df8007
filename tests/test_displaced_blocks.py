"""Blocks for a node in another namespace than that in which it is started: slips, or sets of values to choose from."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.testing import lint_files

NATIVE = existing_files(BACKDROPS["ament_cmake"])
INSTALL = "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package"
LAUNCH = """\
<launch>
  <node pkg="turtlesim" exec="turtlesim_node" name="sim_node" namespace="front">
    <param from="$(find-pkg-share my_pkg)/config/robot.yaml"/>
  </node>
</launch>
"""
BLOCK = "{}:\n  {}:\n    ros__parameters:\n      background_r: 0\n"


def found(*spaces: str) -> list[tuple[int, str]]:
    files = {
        **NATIVE,
        "package.xml": manifest("  <exec_depend>turtlesim</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", INSTALL),
        "launch/robot.launch.xml": LAUNCH,
        "config/robot.yaml": "".join(BLOCK.format(*each.split("/")) for each in spaces),
    }
    return [(each.location.line, each.severity.value) for each in lint_files(files, ["PRM003"]).findings]


@pytest.mark.parametrize(
    ("spaces", "expected"),
    [
        (("front/sim_node",), []),
        (("rear/sim_node",), [(2, "warning")]),
        (("rear/sim_node", "front/sim_node"), [(2, "info")]),
        (("rear/sim_node", "left/sim_node"), [(2, "info"), (6, "info")]),
        (("rear/sim_node", "rear/other"), [(2, "warning")]),
    ],
)
def test_one_of_several_namespaces_is_chosen(spaces: tuple[str, ...], expected: list[tuple[int, str]]) -> None:
    assert found(*spaces) == expected
