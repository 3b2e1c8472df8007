"""Files that are missing on purpose: a folder that is kept for what people make, and pages that have them made."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

PACKAGE = {
    "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
    "CMakeLists.txt": CMAKE.replace(
        "ament_package",
        "install(DIRECTORY launch maps config calibration DESTINATION share/${PROJECT_NAME})\nament_package",
    ),
    "maps/.gitkeep": "",
    "config/.gitkeep": "",
    "calibration/.placeholder": "",
}
LAUNCH = """\
<launch>
  <arg name="name"/>
  <node pkg="p" exec="e" args="-f $(find-pkg-share my_pkg)/{}"/>
</launch>
"""
PARAMETERS = "camera:\n  ros__parameters:\n    camera_info_url: package://my_pkg/calibration/ost.yaml\n"
OFFICE = "maps/office.yaml"


def told(rule: str, path: str = OFFICE, **files: str | None) -> list[str]:
    """Return the levels of a rule, and what is said of them before the advice."""
    others = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in files.items()}
    given = {**PACKAGE, "launch/a.launch.xml": LAUNCH.format(path), **others}
    found = lint_files({name: text for name, text in given.items() if text is not None}, [rule]).findings
    return [f"{each.severity.value}: {each.message.partition('finds nothing there')[2]}" for each in found]


KEPT = ", until people put one into `{}/`, which is kept empty for theirs; add it, or correct the path"
MADE = ", until it is fetched or made, as a page or a script here says; add it, or correct the path"
LOUD = ["warning: ; add it, or correct the path"]


def test_a_folder_that_is_kept_empty_for_maps_is_for_people() -> None:
    assert told("LCH003") == [f"info: {KEPT.format('maps')}"]
    assert told("LCH003", "maps/$(var name).yaml") == [f"info: {KEPT.format('maps')}"]


def test_other_files_in_the_folder_show_that_it_is_not_kept_for_people() -> None:
    assert told("LCH003", maps__hall_DOT_pgm="P5") == LOUD
    assert told("LCH003", "maps/$(var name)_map.yaml", maps__hall_DOT_yaml="a: 1\n") == LOUD
    assert told("LCH003", "maps/$(var name)_map.yaml", maps__hall_DOT_pgm="P5") == [
        "info: , until people add one of theirs to `maps/`; add it, or correct the path"
    ]


def test_a_folder_for_code_that_git_keeps_empty_says_nothing() -> None:
    assert told("LCH003", "config/robot.json") == LOUD
    assert told("LCH003", "config/robot.json", config__README_DOT_md="Put the file of your robot here.\n") == [
        f"info: {KEPT.format('config')}"
    ]


def test_what_the_launch_reads_as_code_is_not_for_people() -> None:
    launch = '<launch>\n  <include file="$(find-pkg-share my_pkg)/maps/b.launch.xml"/>\n</launch>\n'
    (text,) = told("LCH003", launch__a_DOT_launch_DOT_xml=launch)
    assert text.startswith("error: ")


def test_a_mesh_in_a_folder_that_is_kept_for_models_is_for_people() -> None:
    robot = """<robot name="r"><link name="l"><visual><geometry>
    <mesh filename="package://my_pkg/maps/base.stl"/></geometry></visual></link></robot>"""
    files = {
        "CMakeLists_DOT_txt": PACKAGE["CMakeLists.txt"].replace("calibration", "urdf"),
        "urdf__robot_DOT_urdf": robot,
    }
    text = "`my_pkg` has no file `maps/base.stl`: it is missing wherever the robot is shown"
    put = (
        f"info: {text}, until people put one into `maps/`, which is kept empty for theirs; add it, or correct the path"
    )
    assert of_robot(**files) == [put]
    assert of_robot(**files, maps__hall_DOT_pgm="P5") == [f"warning: {text}; add it, or correct the path"]


def of_robot(**files: str) -> list[str]:
    others = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in files.items()}
    found = lint_files({**PACKAGE, "launch/a.launch.xml": LAUNCH.format("urdf/robot.urdf"), **others}, ["URD002"])
    return [f"{each.severity.value}: {each.message}" for each in found.findings]


def test_calibrations_that_parameters_name_are_for_people() -> None:
    launch = '<launch>\n  <node pkg="p" exec="e">\n    <param from="$(find-pkg-share my_pkg)/config/c.yaml"/>\n'
    files = {"config__c_DOT_yaml": PARAMETERS, "launch__a_DOT_launch_DOT_xml": f"{launch}  </node>\n</launch>\n"}
    assert told("PRM010", **files) == [f"info: {KEPT.format('calibration')}"]
    reads = {"my_pkg__node_DOT_py": "def start(node):\n    return node.declare_parameter('camera_info_url', '')\n"}
    assert told("PRM010", calibration__other_DOT_txt="", **files, **reads) == LOUD


@pytest.mark.parametrize(
    "line",
    [
        "Save the map as `maps/office.yaml`.",
        "    ros2 run nav2_map_server map_saver_cli -f ~/ws/src/my_pkg/maps/office",
        "    ros2 service call /save_map slam_toolbox/srv/SaveMap \"{name: {data: 'office'}}\"",
        "    cp ~/office.yaml ~/ws/src/my_pkg/maps/office.yaml",
        "    wget https://example.org/office.yaml",
    ],
)
def test_a_page_that_has_the_file_made_leaves_it_to_people(line: str) -> None:
    assert told("LCH003", maps__hall_DOT_pgm="P5", README_DOT_md=f"# Maps\n\n{line}\n") == [f"info: {MADE}"]


@pytest.mark.parametrize(
    "line",
    [
        "Start it with `map:=maps/office.yaml`.",
        "- `maps/office.yaml`: created with SLAM",
        "    ros2 run nav2_map_server map_saver_cli -f ~/maps/hall",
        "    export MAP=maps/office.yaml",
        "    cp maps/office.yaml ~/",
        "Save the map as `my_office.yaml`.",
    ],
)
def test_a_page_that_names_the_file_makes_none(line: str) -> None:
    assert told("LCH003", maps__hall_DOT_pgm="P5", README_DOT_md=f"# Maps\n\n{line}\n") == LOUD


SAVER = """\
class Saver(Node):
    def __init__(self):
        super().__init__('saver')
        self.declare_parameter('pose_file', '')
        self.pose_file = self.get_parameter('pose_file').value

    def save(self):
        with open(self.pose_file, 'w') as out:
            out.write('{}')
"""
SAVES = """\
<launch>
  <node pkg="my_pkg" exec="saver.py"><param name="pose_file" value="$(find-pkg-share my_pkg)/config/pose.json"/></node>
</launch>
"""
WRITTEN = ["info: , until `scripts/saver.py` has written it; add it, or correct the path"]


def test_what_a_node_of_the_package_writes_is_missing_until_it_ran() -> None:
    files = {"launch__a_DOT_launch_DOT_xml": SAVES, "scripts__saver_DOT_py": SAVER}
    assert told("LCH003", **files) == WRITTEN
    assert told("LCH003", **{**files, "scripts__saver_DOT_py": SAVER.replace(", 'w'", "")}) == LOUD
    reader = SAVES.replace("saver.py", "docker.py")
    assert told("LCH003", **{**files, "launch__a_DOT_launch_DOT_xml": reader}) == LOUD
    assert told("LCH003", **{**files, "launch__b_DOT_launch_DOT_xml": reader}) == [*WRITTEN, *WRITTEN]


CPP_SAVER = """\
Saver() : Node("saver")
{
  pose_file_ = declare_parameter<std::string>("pose_file", "");
}
void save()
{
  std::string path = pose_file_;
  this->get_parameter("pose_file", path);
  std::ofstream out(path);
}
"""


@pytest.mark.parametrize(
    ("code", "expected"),
    [
        (CPP_SAVER, ["info: , until `src/saver.cpp` has written it; add it, or correct the path"]),
        (CPP_SAVER.replace("out(path)", "out(other)").replace("ofstream out", "ifstream in"), LOUD),
        (CPP_SAVER.replace("std::of", "// std::of"), LOUD),
        (CPP_SAVER.replace('"pose_file"', '"other_file"'), LOUD),
    ],
)
def test_what_a_node_in_cpp_writes_is_missing_until_it_ran(code: str, expected: list[str]) -> None:
    files = {"launch__a_DOT_launch_DOT_xml": SAVES.replace("saver.py", "saver"), "src__saver_DOT_cpp": code}
    assert told("LCH003", **files) == expected


STAGED = """\
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

SHARE = get_package_share_directory('my_pkg')


def stage(context, saved, loaded):
    saver = Node(package='my_pkg', executable='saver', parameters=[{'pose_file': str(saved.perform(context))}])
    walker = Node(package='my_pkg', executable='walker', parameters=[{'route': str(loaded.perform(context))}])
    return [saver, walker]


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('save_path', default_value=SHARE + '/config/pose.json'),
        DeclareLaunchArgument('load_path', default_value=SHARE + '/config/pose.json'),
        OpaqueFunction(function=stage, args=[LaunchConfiguration('save_path'), LaunchConfiguration('load_path')]),
    ])
"""


@pytest.mark.parametrize(
    ("launch", "code", "level"),
    [
        (STAGED, CPP_SAVER, "info"),
        (STAGED.replace("save_path", "poses_path"), CPP_SAVER, "warning"),
        (STAGED.replace("'saver'", "'docker'"), CPP_SAVER, "warning"),
        (STAGED.replace("str(saved.perform(context))", "'/tmp/pose.json'"), CPP_SAVER, "warning"),
        (STAGED.replace("'save_path', default_value=SHARE + '/config/pose", "'save_path', default_value='/tmp/pose"),
         CPP_SAVER, "warning"),
        (STAGED, CPP_SAVER.replace("ofstream", "ifstream"), "warning"),
    ],
)  # fmt: skip
def test_the_default_of_an_argument_for_what_a_node_saves(launch: str, code: str, level: str) -> None:
    """Also where another file has a similar name, and where another node reads it."""
    files = {**PACKAGE, "launch/a.launch.py": launch, "src/saver.cpp": code, "config/pose_template.json": "{}"}
    (found,) = lint_files(files, ["LCH003"]).findings
    assert found.severity.value == level
    assert ("until `src/saver.cpp` has written it" in found.message) is (level == "info")


WALKS = """\
from setuptools import setup

found = [(root, files) for root, _, files in os.walk('{}')]
setup(name='my_pkg', data_files=[('share/my_pkg', ['package.xml']), ('share/my_pkg/launch', ['launch/a.launch.xml'])])
"""
BROUGHT = (
    "info: , until people add it to `resource/`, which is installed, and which git ignores; add it, or correct the path"
)


@pytest.mark.parametrize(
    ("ignored", "walked", "expected"),
    [
        ("resource/\n!resource/my_pkg\n", "resource", [BROUGHT]),
        ("resource/urdf\n", "./resource/", [BROUGHT]),
        ("resource/meshes\n", "resource", LOUD),
        ("resource/\n", "config", LOUD),
        ("", "resource", LOUD),
    ],
)
def test_a_folder_that_git_ignores_and_setup_py_installs(ignored: str, walked: str, expected: list[str]) -> None:
    files = {"_DOT_gitignore": ignored, "setup_DOT_py": WALKS.format(walked), "CMakeLists_DOT_txt": None}
    files["package_DOT_xml"] = manifest("  <exec_depend>ros2launch</exec_depend>\n")
    assert told("LCH003", "urdf/a.urdf", **files) == expected


def test_a_folder_that_git_ignores_and_cmake_installs() -> None:
    installs = (
        "install(DIRECTORY launch DESTINATION share/my_pkg)\ninstall(DIRECTORY resource/ DESTINATION share/my_pkg)\n"
    )
    cmake = CMAKE.replace("ament_package", f"{installs}ament_package")
    files: dict[str, str | None] = {"resource__a_DOT_txt": "", "CMakeLists_DOT_txt": cmake}
    assert told("LCH003", "urdf/a.urdf", **files) == LOUD
    assert told("LCH003", "urdf/a.urdf", _DOT_gitignore="/resource\n", **files) == [BROUGHT]
