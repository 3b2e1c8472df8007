"""URD001: a file that a robot includes need not have all links that its joints name: the robot has them."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

XACRO = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"{}>\n{}\n</robot>\n'
LINKS = '<link name="laser_link"/><link name="camera_link"/>'
JOINTS = "".join(
    f'<joint name="{each}_joint" type="fixed"><parent link="base_link"/><child link="{each}_link"/></joint>'
    for each in ("laser", "camera")
)
INCLUDE = '<xacro:include filename="$(find my_pkg)/urdf/{}.xacro"/>'
LAUNCH = '<launch><let name="m" value="$(find-pkg-share my_pkg)/urdf/robot.xacro"/></launch>\n'


def found(base: str) -> list[tuple[str, str]]:
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace(
            "ament_package", "install(DIRECTORY launch urdf DESTINATION share/x)\nament_package"
        ),
        "launch/a.launch.xml": LAUNCH,
        "urdf/robot.xacro": XACRO.format(' name="r"', INCLUDE.format("base") + INCLUDE.format("sensors")),
        "urdf/base.xacro": XACRO.format("", base),
        "urdf/sensors.xacro": XACRO.format("", LINKS + JOINTS),
    }
    hits = lint_files(files, ["URD001"]).findings
    return [(each.severity.value, each.message.partition(":")[0]) for each in hits]


@pytest.mark.parametrize("name", ["base_link", "${'base' + '_link'}"])
def test_the_robot_has_the_link(name: str) -> None:
    assert found(f'<link name="{name}"/>') == []


def test_the_robot_lacks_the_link() -> None:
    ((level, message),) = found('<link name="bases_link"/>')
    assert level == "error"
    assert message.startswith("no link is called `base_link`")


@pytest.mark.parametrize(
    "more, said",
    [
        ('<link name="arm"/>', [("error", "no joint joins `arm` to `base_link`")]),
        ('<link name="$(arg prefix)arm"/>', []),
        ('<xacro:if value="$(arg with_arm)"><link name="arm"/></xacro:if>', []),
        ('<xacro:include filename="$(find elsewhere)/urdf/arm.xacro"/><link name="arm"/>', []),
        ('<link name="arm"/><joint name="a" type="fixed"><parent link="base_link"/><child link="arm"/></joint>', []),
    ],
)
def test_a_link_that_no_joint_joins(more: str, said: list[tuple[str, str]]) -> None:
    """urdfdom refuses two roots, in a robot that xacro puts together as well."""
    assert found(f'<link name="base_link"/>{more}') == said
