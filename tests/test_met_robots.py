"""URD001 and URD002: a fault of a robot is more than an info only where something is shown to open the robot.

URD001 asks for a launch file, and for what surely stops.
"""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

INSTALLS = "install(DIRECTORY launch urdf DESTINATION share/${PROJECT_NAME})\nament_package"
LOST = '<link name="l"><visual><geometry><mesh filename="{}"/></geometry></visual></link>'
MESH = LOST.format("package://my_pkg/urdf/a.stl")
HOME = LOST.format("file:///home/ada/ws/src/my_pkg/meshes/a.stl")
JOINT = '<link name="a"/><link name="b"/>'
PROGRAM = CMAKE.replace(
    "ament_package", f"install(PROGRAMS scripts/show.py DESTINATION lib/${{PROJECT_NAME}})\n{INSTALLS}"
)
FILES = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": CMAKE.replace("ament_package", INSTALLS)}
NAMED = "from launch import LaunchDescription\n\nMODEL = {}\n\n\ndef generate_launch_description():\n    {}\n"
ADDED = "return LaunchDescription([Node(package='a', executable='b', parameters=[{{'robot_description': {}}}])])"
OPENED = {"launch/a.launch.py": NAMED.format("share + '/urdf/robot.urdf'", ADDED.format("open(MODEL).read()"))}
CODE = "import xacro\n\n\ndef main():\n    publish('robot_description', xacro.process_file(share + '/urdf/{}'))\n"


def levels(more: dict[str, str], robot: str = MESH) -> list[str]:
    files = {**FILES, "urdf/robot.urdf": f'<robot name="r">{robot}</robot>\n', **more}
    return [each.severity.value for each in lint_files(files, ["URD001", "URD002"]).findings]


MAYBE = [
    {},
    {"README.md": "`urdf/robot.urdf` is what SolidWorks exported.\n"},
    {"launch/a.launch.py": NAMED.format("share + '/urdf/' + NAME + '.urdf'", ADDED.format("open(MODEL).read()"))},
    {"launch/a.launch.py": NAMED.format("'robot.urdf.xacro'", ADDED.format("open(MODEL).read()"))},
    {"launch/a.launch.py": NAMED.format("None", "lost = Node(package='robot.urdf')\n    return LaunchDescription([])")},
    {"launch/a.launch.py": NAMED.format("None", "return LaunchDescription([])  # robot.urdf")},
    {"scripts/show.py": CODE.format("robot.urdf.xacro"), "CMakeLists.txt": PROGRAM},
    {"scripts/show.py": CODE.format("robot.urdf")},
    {**OPENED, "launch/b.launch.py": NAMED.format("None", "return LaunchDescription([])"),
     "CMakeLists.txt": CMAKE.replace("ament_package", INSTALLS.replace("launch urdf", "urdf").replace(
         "install(", "install(FILES launch/b.launch.py DESTINATION share/${PROJECT_NAME})\ninstall(", 1))},
]  # fmt: skip


@pytest.mark.parametrize("more", MAYBE)
@pytest.mark.parametrize("robot", [MESH, HOME, JOINT])
def test_what_nothing_is_shown_to_open_is_an_info(more: dict[str, str], robot: str) -> None:
    assert set(levels(more, robot)) == {"info"}


@pytest.mark.parametrize(
    "more",
    [
        OPENED,
        {"README.md": "    ros2 launch urdf_tutorial display.launch.py model:=urdf/robot.urdf\n"},
        {"scripts/show.py": CODE.format("robot.urdf"), "CMakeLists.txt": PROGRAM},
        {"urdf/whole.urdf.xacro": '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="w">'
         '<xacro:include filename="robot.urdf"/></robot>\n', "start.sh": "xacro urdf/whole.urdf.xacro\n"},
    ],
)  # fmt: skip
@pytest.mark.parametrize("robot", [MESH, HOME])
def test_what_something_is_shown_to_open_is_a_warning(more: dict[str, str], robot: str) -> None:
    assert levels(more, robot) == ["warning"]


def test_only_what_a_launch_file_opens_is_an_error() -> None:
    assert set(levels(OPENED, JOINT)) == {"error"}
    assert set(levels({"scripts/show.py": CODE.format("robot.urdf")}, JOINT)) == {"info"}


def test_a_page_above_counts_where_it_names_the_package() -> None:
    def found(line: str) -> list[str]:
        files = {f"src/my_pkg/{path}": text for path, text in FILES.items()}
        files["src/my_pkg/urdf/robot.urdf"] = f'<robot name="r">{MESH}</robot>\n'
        told = lint_files({**files, "README.md": f"    {line}\n"}, ["URD002"]).findings
        return [each.severity.value for each in told]

    assert found("ros2 launch urdf_tutorial display.launch.py model:=src/my_pkg/urdf/robot.urdf") == ["warning"]
    assert found("ros2 launch urdf_tutorial display.launch.py model:=src/other/urdf/robot.urdf") == ["info"]


@pytest.mark.parametrize("package", ["my_pkg", "other"])
@pytest.mark.parametrize(("name", "level"), [("hall.world", "warning"), ("halls.world", "info")])
def test_worlds_are_opened_by_launch_files_too(package: str, name: str, level: str) -> None:
    world = (
        f'<sdf version="1.6"><world name="w"><model name="m">{HOME.replace("filename=", "uri=")}</model></world></sdf>'
    )
    world = world.replace('<mesh uri="', "<mesh><uri>").replace('"/>', "</uri></mesh>")
    files = {f"my_pkg/{path}": text for path, text in FILES.items()}
    files["other/package.xml"] = manifest("", "ament_cmake", "other")
    files["my_pkg/worlds/hall.world"] = world
    launch = NAMED.format(f"share('my_pkg') + '/worlds/{name}'", ADDED.format("MODEL"))
    (found,) = lint_files({**files, f"{package}/launch/a.launch.py": launch}, ["URD002"]).findings
    assert found.severity.value == level


XACRO = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">{}</robot>\n'
MACRO = XACRO.format('<xacro:macro name="arm" params="side">{}</xacro:macro>')
SLIP = '{}<link name="hand_{{side}}"/>{}'
CALLS = XACRO.format('<xacro:include filename="arm.xacro"/><link name="l"/>{}')
OPENS_XACRO = {"launch/a.launch.py": NAMED.format("share + '/urdf/r.xacro'", ADDED.format("xacro.process_file(MODEL)"))}


def slip_levels(robot: str, macro: str, **more: str) -> list[str]:
    files = {**FILES, **OPENS_XACRO, "urdf/r.xacro": robot, "urdf/arm.xacro": macro, **more}
    return [
        each.severity.value for each in lint_files(files, ["URD001"]).findings if each.location.path == "urdf/arm.xacro"
    ]


def test_a_macro_that_only_an_unopened_robot_calls() -> None:
    call, macro = '<xacro:arm side="a"/>', MACRO.format(SLIP.format("", ""))
    assert slip_levels(CALLS.format(call), macro) == ["info"]
    assert slip_levels(CALLS.format(""), macro, **{"urdf/spare.xacro": CALLS.format(call)}) == ["info"]


def test_what_gazebo_leaves_out_is_an_info() -> None:
    block = '<gazebo reference="wheel_{side}"><mu1>0.2</mu1></gazebo>'
    assert slip_levels(CALLS.format('<xacro:arm side="a"/>'), MACRO.format(block)) == ["info"]


ELSEWHERE = [
    ("urdf_spare/robot.urdf", "share + '/urdf/robot.urdf'"),
    ("urdf_spare/robot.urdf", "os.path.join(share, 'urdf', 'robot.urdf')"),
]


@pytest.mark.parametrize(("path", "named"), ELSEWHERE)
@pytest.mark.parametrize("robot", [MESH, JOINT])
def test_a_robot_named_with_another_folder_is_not_opened(path: str, named: str, robot: str) -> None:
    files = {path: f'<robot name="r">{robot}</robot>\n', "urdf/other.urdf": '<robot name="o"/>'}
    opened = NAMED.format(named, ADDED.format("open(MODEL).read()"))
    found = lint_files({**FILES, **files, "launch/a.launch.py": opened}, ["URD001", "URD002"]).findings
    assert {each.severity.value for each in found if each.location.path == path} == {"info"}


@pytest.mark.parametrize(
    "named",
    [
        "os.path.join(folder, 'robot.urdf')",
        "f'{folder}/robot.urdf'",
        "'urdf/robot.urdf'",
        "DeclareLaunchArgument('model', 'robot.urdf')",
        "['other.urdf', 'robot.urdf']",
    ],
)
def test_a_robot_named_alone_or_with_a_folder_of_the_install_is_opened(named: str) -> None:
    opened = NAMED.format(named, ADDED.format("open(MODEL).read()"))
    installs = "install(FILES robots/robot.urdf DESTINATION share/${PROJECT_NAME}/urdf)\nament_package"
    files = {"robots/robot.urdf": f'<robot name="r">{HOME}</robot>\n', "launch/a.launch.py": opened}
    cmake = {"CMakeLists.txt": FILES["CMakeLists.txt"].replace("ament_package", installs)}
    found = lint_files({**FILES, **cmake, **files}, ["URD002"]).findings
    assert [each.severity.value for each in found] == ["warning"]


def test_another_package_means_its_own_file_where_it_names_its_folder() -> None:
    one = {f"one/{path}": text for path, text in FILES.items()}
    one["one/urdf/robot.urdf"] = f'<robot name="r">{MESH}</robot>\n'
    two = {f"two/{path}": text.replace("my_pkg", "two") for path, text in FILES.items()}
    two["two/config/robot.urdf"] = '<robot name="r"><link name="a"/></robot>\n'
    two["two/CMakeLists.txt"] = two["two/CMakeLists.txt"].replace("launch urdf", "launch config")
    named = "join(get('my_pkg'), get('two'), 'config', 'robot.urdf')"
    two["two/launch/a.launch.py"] = NAMED.format(named, ADDED.format("open(MODEL).read()"))
    found = lint_files({**one, **two}, ["URD002"]).findings
    assert [each.severity.value for each in found] == ["info"]
