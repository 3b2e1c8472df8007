"""Robot descriptions: urdfdom's verdict, xacro's substitutions, and the files that they name."""

from __future__ import annotations

import pytest
from urdf_texts import JOINT, PAIR, REFUSED, TAKEN

from rospkg_cli.checks.urdf.substitutions import substitution_fault
from rospkg_cli.checks.urdf.validation import robot_faults
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.package.urdf.reader import robot_file
from rospkg_cli.package.urdf.robot_file import RobotFile
from rospkg_cli.source import Source
from rospkg_cli.testing import lint_files
from rospkg_cli.unreadable import UnreadableError


def read(body: str, path: str = "urdf/robot.urdf", head: str = '<robot name="r">') -> RobotFile:
    return robot_file(Source(path, f"{head}{body}</robot>"))


@pytest.mark.parametrize("body", TAKEN)
def test_what_urdfdom_takes(body: str) -> None:
    assert robot_faults(read(body)) == []


@pytest.mark.parametrize("body", REFUSED)
def test_what_urdfdom_refuses(body: str) -> None:
    assert [fault for fault in robot_faults(read(body)) if fault.level is None]


@pytest.mark.parametrize(
    "inside",
    [
        "<inertial/>",
        '<inertial><mass value="1"/><inertia ixx="1"/></inertial>',
        "<visual/>",
        "<visual><geometry/></visual>",
        "<collision><geometry><sphere/></geometry></collision>",
        '<visual><geometry><mesh filename="m" scale="1 1"/></geometry></visual>',
        '<visual><geometry><ball radius="1"/></geometry></visual>',
        '<visual><geometry><sphere radius="nan"/></geometry></visual>',
    ],
)
def test_what_costs_a_link_its_shapes_is_a_warning(inside: str) -> None:
    faults = robot_faults(read(f'<link name="a">{inside}</link>'))
    assert faults
    assert all(fault.level == "warning" for fault in faults)


def test_a_circle_beside_the_root_is_reported() -> None:
    """check_urdf takes it; nobody can move such a robot."""
    ring = '<link name="c"/><link name="d"/>'
    for parent, child in ("cd", "dc"):
        ring += f'<joint name="{child}" type="fixed"><parent link="{parent}"/><child link="{child}"/></joint>'
    (fault,) = robot_faults(read(PAIR + JOINT.format("") + ring))
    assert "circle" in fault.message


@pytest.mark.parametrize("block", ['xacro:if value="$(arg arm)"', 'xacro:macro name="arm" params="x"'])
def test_two_joints_of_a_block_have_one_name(block: str) -> None:
    """An include that is not here may hide the rest of the robot, but not what stands side by side."""
    other = JOINT.format("").replace('"j"', '"k"')
    inside = f"{JOINT.format('')}\n<{block}>{other * 2}<joint name='k'/></{block.split()[0]}>"
    text = f'<xacro:include filename="$(find other)/a.xacro"/>{PAIR}{inside}'
    (fault,) = robot_faults(read(text, "urdf/a.urdf.xacro", XACRO))
    assert fault.message.startswith("two joints are called `k")


def test_names_are_suggested() -> None:
    (fault,) = robot_faults(read(PAIR.replace('"b"', '"wheel"') + JOINT.format("").replace('"b"', '"whele"')))
    assert "did you mean `wheel`" in fault.message


XACRO = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">'


@pytest.mark.parametrize(
    "body",
    [
        JOINT.format(""),
        '<xacro:macro name="m" params="p"><joint name="j" type="revolute"><xacro:insert_block name="l"/></joint>'
        "</xacro:macro>",
        '<link name="${p}_a"/><link name="${p}_a"/>',
        '<link name="a"><visual><origin xyz="${x} 0 0"/><geometry><box size="${s}"/></geometry></visual></link>',
        '<ros2_control name="c"><joint name="j"><limit/></joint></ros2_control>',
    ],
)
def test_pieces_of_xacro_are_believed(body: str) -> None:
    assert robot_faults(read(body, "urdf/piece.xacro", XACRO)) == []


@pytest.mark.parametrize(
    "text",
    ["${a * (b + 1)}", "$(find my_pkg)/x", "$(arg a)", "$$(not one)", "5 $ a", "${'x' if a else ''}", "$(eval a or b)",
     "$(optenv A b c)", "${dict(a=1)['a']}", "$(dirname)/a"],
)  # fmt: skip
def test_substitutions_that_xacro_takes(text: str) -> None:
    assert substitution_fault(text) is None


@pytest.mark.parametrize(
    "text",
    ["${a", "$(find my_pkg", "$(find-pkg-share my_pkg)", "$(var a)", "$(find)", "$(arg a b)", "${a b}", "${}", "$()"],
)
def test_substitutions_that_xacro_refuses(text: str) -> None:
    assert substitution_fault("before " + text) is not None


def test_a_line_end_in_an_attribute_is_a_blank() -> None:
    assert robot_faults(read('<link name="${a or\n b}"/>', "urdf/a.xacro", XACRO)) == []


def test_a_line_end_in_a_text_stays_one() -> None:
    (fault,) = robot_faults(read('<link name="a"><p>${a or\n b}</p></link>', "urdf/a.xacro", XACRO))
    assert "holds no expression that xacro can evaluate" in fault.message


def test_tinyxml_minds_less() -> None:
    assert robot_file(Source("a.urdf", '\n<?xml version="1.0"?>\n<robot name="r"><s:x/><link name="a"/></robot>')).links
    with pytest.raises(UnreadableError):
        robot_file(Source("a.xacro", '\n<?xml version="1.0"?>\n<robot name="r"/>'))


def workspace(text: str, path: str = "urdf/robot.xacro") -> dict[str, str]:
    cmake = "install(DIRECTORY meshes urdf DESTINATION share/${PROJECT_NAME})\nament_package"
    both = {}
    for name in ("robot", "parts"):
        both[f"src/{name}/package.xml"] = manifest("", "ament_cmake", name)
        both[f"src/{name}/CMakeLists.txt"] = CMAKE.replace("my_pkg", name).replace("ament_package", cmake)
        both[f"src/{name}/meshes/arm.stl"] = both[f"src/{name}/meshes/arm v2 left.stl"] = "solid\n"
        both[f"src/{name}/urdf/wheel.xacro"] = XACRO + "</robot>\n"
        both[f"src/{name}/secret/key.stl"] = "solid\n"
    return {**both, f"src/robot/{path}": f"{XACRO}{text}</robot>\n"}


@pytest.mark.parametrize(
    "text, said",
    [
        ('<m f="package://robot/meshes/arm.stl"/>', ""),
        ('<m f="package://parts/meshes/arm.stl"/>', ""),
        ('<m f="package://parts/meshes/Arm.stl"/>', "did you mean `meshes/arm.stl`"),
        ('<m f="package://robot/secret/key.stl"/>', "`robot` does not install it"),
        ('<m f="package://parts/secret/key.stl"/>', "`parts` installs no folder `secret`"),
        ('<m f="package://elsewhere/meshes/x.stl"/>', ""),
        ('<m f="package://parts/meshes/${name}.stl"/>', ""),
        ('<mesh filename="package://parts/meshes/arm v2 left.stl"/>', ""),
        ('<mesh filename="package://parts/meshes/arm v2 right.stl"/>', "`meshes/arm v2 right.stl`"),
        ('<m f="package://parts/meshes/arm.stl and more"/>', ""),
        ("<uri> package://parts/meshes/arm v2 left.stl </uri>", ""),
        ("<uri>package://parts/meshes/arm v2 right.stl</uri>", "`meshes/arm v2 right.stl`"),
        ('<m f="$(find parts)/meshes"/>', ""),
        ("<p>$(find parts)/config/c.yaml</p>", "`config/c.yaml`"),
        ('<xacro:include filename="$(find parts)/urdf/wheels.xacro"/>', "xacro stops here"),
        ('<xacro:include filename="wheel.xacro"/>', ""),
        ('<xacro:include filename="whel.xacro"/>', "did you mean `wheel.xacro`"),
        ('<xacro:property name="d" value="meshes"/><m f="package://robot/${d}/arm.stl"/>', ""),
        ('<xacro:property name="d" value="meshes"/><m f="package://robot/${d}/leg.stl"/>', "`meshes/leg.stl`"),
        ('<!-- <m f="package://robot/meshes/leg.stl"/> -->', ""),
    ],
)
def test_files_that_are_named(text: str, said: str) -> None:
    found = lint_files(workspace(text), ["URD002"]).findings
    assert bool(found) is bool(said), [finding.message for finding in found]
    assert all(said in finding.message for finding in found)


def test_a_file_is_named_once_and_its_places_are_related() -> None:
    text = '<m f="package://robot/meshes/leg.stl"/>' * 3
    (finding,) = lint_files(workspace(text), ["URD002"]).findings
    assert len(finding.related) == 2


def test_a_file_beside_installed_ones_that_is_not_installed() -> None:
    files = workspace('<m f="package://robot/meshes/leg.obj"/>')
    files["src/robot/meshes/leg.obj"] = "o\n"
    cmake = files["src/robot/CMakeLists.txt"]
    files["src/robot/CMakeLists.txt"] = cmake.replace("urdf DEST", "urdf DEST").replace(
        "share/${PROJECT_NAME})", 'share/${PROJECT_NAME} PATTERN "*.obj" EXCLUDE)'
    )
    (finding,) = lint_files(files, ["URD002"]).findings
    assert "does not install it" in finding.message


def test_a_file_that_may_be_installed_by_other_means() -> None:
    files = workspace('<m f="package://robot/meshes/Arm.stl"/>')
    files["src/robot/meshes/Arm.stl"] = "solid\n"
    cmake = files["src/robot/CMakeLists.txt"].replace("NAME})", 'NAME} PATTERN "Arm.stl" EXCLUDE)')
    assert len(lint_files({**files, "src/robot/CMakeLists.txt": cmake}, ["URD002"]).findings) == 1
    unknown = cmake.replace("ament_package", "install(FILES ${MESHES} DESTINATION share/my_pkg)\nament_package")
    assert lint_files({**files, "src/robot/CMakeLists.txt": unknown}, ["URD002"]).findings == ()


def test_worlds_are_followed_too() -> None:
    files = workspace("")
    files["src/robot/worlds/w.world"] = "<sdf><uri>package://robot/meshes/leg.stl</uri></sdf>\n"
    (finding,) = lint_files(files, ["URD001", "URD002"]).findings
    assert finding.location.path == "src/robot/worlds/w.world"


@pytest.mark.parametrize(
    "attributes, lacked",
    [
        ('ixx="${m}" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"', []),
        ('ixx="${m}" iyy="1" izz="1" ixy="0" ixz="0"', ["`<inertia>` has no `iyz`; urdfdom leaves out what it is in"]),
        ("", []),
        ('ixx="1" xacro:rest="1"', []),
    ],
)
def test_an_inertia_in_a_macro(attributes: str, lacked: list[str]) -> None:
    inside = f'<inertial><mass value="1"/><inertia {attributes}/></inertial>'
    body = f'<xacro:macro name="inertial" params="m">{inside}</xacro:macro>'
    assert [fault.message for fault in robot_faults(read(body, "urdf/a.xacro", XACRO))] == lacked
