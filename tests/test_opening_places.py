"""RPK001: a world, a robot or a behavior tree that can't be read is an error where something is shown to open it."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

INSTALLS = CMAKE.replace(
    "ament_package", "install(DIRECTORY config launch trees worlds DESTINATION share/${PROJECT_NAME})\nament_package"
)
WORLD, TREE = "worlds/empty.sdf", "trees/go.xml"
BROKEN = {WORLD: "<sdf><world></sdf>\n", TREE: "<root><BehaviorTree></root>\n"}
LAUNCH = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.substitutions import LaunchConfiguration
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    asked = LaunchConfiguration('file')
    return LaunchDescription([{}])
"""
DECLARED = "DeclareLaunchArgument('file', default_value=[FindPackageShare('my_pkg'), '/trees/go.xml']), {}"
YAML = "bt_navigator:\n  ros__parameters:\n    {}: $(find-pkg-share my_pkg)/trees/go.xml\n"


def told(path: str, **files: str) -> str:
    named = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in files.items()}
    base = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": INSTALLS, path: BROKEN[path]}
    (finding,) = lint_files({**base, **named}, ["RPK001"]).findings
    return finding.severity.value


@pytest.mark.parametrize(
    ("text", "level"),
    [
        ("LogInfo(msg='-r empty.sdf')", "info"),
        ("LogInfo(msg=[FindPackageShare('my_pkg'), '/worlds/empty.sdf'])", "error"),
        ("LogInfo(msg=[FindPackageShare('other'), '/models/empty.sdf'])", "info"),
        ("DeclareLaunchArgument('w', default_value='empty.sdf'), LogInfo(msg=['/worlds/', LaunchConfiguration('w')])",
         "error"),
    ],
)  # fmt: skip
def test_a_bare_name_of_a_world_may_be_one_of_gazebo(text: str, level: str) -> None:
    assert told(WORLD, launch__a_DOT_launch_DOT_py=LAUNCH.format(text)) == level


@pytest.mark.parametrize(
    ("line", "level"),
    [
        ("gz sim worlds/empty.sdf", "error"),
        ("gz sim empty.sdf", "info"),
        ("See worlds/empty.sdf.", "info"),
        ("gz sdf -p a.urdf > worlds/empty.sdf", "info"),
    ],
)
def test_a_command_opens_a_world_by_its_place(line: str, level: str) -> None:
    assert told(WORLD, README_DOT_md=f"    {line}\n") == level


@pytest.mark.parametrize(
    ("more", "level"),
    [
        ("", "info"),
        ("LogInfo(msg=LaunchConfiguration('file'))", "error"),
        ("LogInfo(msg=asked)", "error"),
        ("LogInfo(msg='allow_substs')", "info"),
    ],
)
def test_the_default_of_an_argument_that_nothing_reads_opens_nothing(more: str, level: str) -> None:
    assert told(TREE, launch__a_DOT_launch_DOT_py=LAUNCH.format(DECLARED.format(more))) == level


def test_yaml_with_substitutions_reads_an_argument() -> None:
    launch = LAUNCH.format(DECLARED.format("LogInfo(msg='allow_substs')"))
    assert told(TREE, launch__a_DOT_launch_DOT_py=launch, config__a_DOT_yaml="tree: $(var file)\n") == "error"


@pytest.mark.parametrize(("key", "level"), [("default_nav_to_pose_bt_xml", "error"), ("my_tree", "info")])
def test_yaml_opens_a_tree_by_a_key_that_is_read(key: str, level: str) -> None:
    launch = LAUNCH.format("LogInfo(msg=[FindPackageShare('my_pkg'), '/config/nav.yaml'])")
    files = {"config__nav_DOT_yaml": YAML.format(key), "launch__a_DOT_launch_DOT_py": launch}
    assert told(TREE, **files) == level


def test_what_nothing_installs_or_yaml_that_nothing_names_opens_nothing() -> None:
    assert told(TREE, config__nav_DOT_yaml=YAML.format("default_nav_to_pose_bt_xml")) == "info"
    text = "import sys\n\nprint(sys.argv, 'trees/go.xml')\n"
    assert told(TREE, notes__a_DOT_py=text) == "info"


@pytest.mark.parametrize(
    ("line", "level"),
    [
        ("BASE + '/worlds', 'new', 'empty.sdf'", "info"),
        ("BASE + '/worlds/new/empty.sdf'", "info"),
        ("BASE + '/worlds/empty.sdf', 'new'", "error"),
        ("BASE, 'worlds', 'empty.sdf'", "error"),
    ],
)
def test_a_copy_further_in_is_the_one_that_is_meant(line: str, level: str) -> None:
    launch = LAUNCH.format(f"LogInfo(msg=[FindPackageShare('my_pkg'), {line}])")
    inner = {"worlds__new__empty_DOT_sdf": "<sdf/>\n"}
    assert (
        told(WORLD, launch__a_DOT_launch_DOT_py=launch.replace("BASE, ", "").replace("BASE + ", ""), **inner) == level
    )
    assert told(WORLD, launch__a_DOT_launch_DOT_py=launch.replace("BASE, ", "").replace("BASE + ", "")) == "error"
