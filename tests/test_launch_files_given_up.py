"""Launch files that nobody means to start: copies, those that were never ported, and those that launch can't find."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest, scripts, setup_py
from rospkg_cli.package.file_role import is_set_aside
from rospkg_cli.testing import lint_files

NATIVE = existing_files(BACKDROPS["ament_cmake"])
PYTHON = existing_files(BACKDROPS["ament_python"])
INCLUDES = """\
from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    arm = PythonLaunchDescriptionSource([FindPackageShare('my_pkg'), '/launch/arm.launch.py'])
    return LaunchDescription([IncludeLaunchDescription(arm)])
"""
EMPTY = (
    "from launch import LaunchDescription\n\n\ndef generate_launch_description():\n    return LaunchDescription([])\n"
)
UNPORTED = '<launch>\n  <let name="a" value="$(find my_pkg)"/>\n</launch>\n'
UNKNOWN = '<launch>\n  <node pkg="my_pkg" exec="a" nmae="b"/>\n</launch>\n'
STARTED = "ros2 launch my_pkg {}\n"
NODE = '<launch>\n  <node pkg="my_pkg" exec="taker"/>\n</launch>\n'


def level(code: str, files: dict[str, str], on: dict[str, str] = NATIVE, lines: str = "") -> list[str]:
    where = lines or "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n"
    cmake = {"CMakeLists.txt": CMAKE.replace("ament_package", f"{where}ament_package")} if on is NATIVE else {}
    return [each.severity.value for each in lint_files({**on, **cmake, **files}, [code]).findings]


@pytest.mark.parametrize(
    ("path", "is_aside"),
    [
        ("launch/robot.launch copy.py", True),
        ("launch/copy.py", False),
        ("launch/photocopy.launch.py", False),
        ("launch/copy_files.launch.py", False),
    ],
)
def test_copies_by_their_names(path: str, is_aside: bool) -> None:
    assert is_set_aside(path) is is_aside


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({"launch/robot.launch.py": INCLUDES}, ["error"]),
        ({"launch/robot.launch.py": EMPTY, "launch/robot.py": INCLUDES}, ["info"]),
        ({"launch/robot_launch.py": EMPTY, "launch/robot.py": INCLUDES}, ["info"]),
        ({"launch/robot.py": INCLUDES}, ["error"]),
        ({"launch/robot.launch.py": EMPTY, "launch/robot.launch copy.py": INCLUDES}, ["info"]),
        ({"launch/robot.launch.py": EMPTY, "launch/robot_old.launch.py": INCLUDES}, ["info"]),
    ],
)
def test_a_copy_of_a_launch_file_is_started_by_who_names_it(files: dict[str, str], expected: list[str]) -> None:
    assert level("LCH003", files) == expected


def test_a_page_starts_the_bare_file_beside_the_other() -> None:
    files = {"launch/robot.launch.py": EMPTY, "launch/robot.py": INCLUDES}
    assert level("LCH003", {**files, "README.md": STARTED.format("robot.py")}) == ["error"]


@pytest.mark.parametrize(
    ("path", "others", "alone"),
    [
        ("launch/a.launch", {"launch/b.launch.py": EMPTY}, "info"),
        ("launch/a.xml", {"launch/b.launch.py": EMPTY}, "info"),
        ("launch/a.launch", {}, "error"),
        ("launch/a.launch.xml", {"launch/b.launch.py": EMPTY}, "error"),
    ],
)
def test_a_file_that_was_not_ported_whole_is_met_where_it_is_started(
    path: str, others: dict[str, str], alone: str
) -> None:
    """The only launch file of a package is there to start it, and so is one that has the suffix of ROS 2."""
    text = UNPORTED.replace("</launch>", '  <let name="b" value="$(find-pkg-share my_pkg)"/>\n</launch>')
    assert level("LCH006", {path: text, **others}) == [alone]
    assert level("LCH006", {path: text, **others, "README.md": STARTED.format(path[7:])}) == ["error"]


PLUGIN = '  <arg name="a" default="1"/>\n  <param name="plugin" value="moveit::Manager"/>\n'


@pytest.mark.parametrize(
    ("more", "others", "expected"),
    [
        ("", {"launch/b.launch.py": EMPTY}, "info"),
        ("", {}, "error"),
        ('  <let name="b" value="c"/>\n', {"launch/b.launch.py": EMPTY}, "error"),
        ("", {"launch/b.launch.py": EMPTY, "README.md": STARTED.format("a.launch.xml")}, "error"),
    ],
)
def test_a_part_of_ros1_that_only_sets_parameters(more: str, others: dict[str, str], expected: str) -> None:
    text = f"<launch>\n{PLUGIN}{more}</launch>\n"
    assert level("LCH006", {"launch/a.launch.xml": text, **others}) == [expected]


def test_launch_looks_into_share_directories_alone() -> None:
    files = {"launch/a.launch": UNKNOWN, "launch/b.launch": "<launch/>\n"}
    both = "install(DIRECTORY launch DESTINATION lib/${PROJECT_NAME})\n"
    both += "install(FILES launch/b.launch DESTINATION share/${PROJECT_NAME}/launch)\n"
    assert level("LCH007", files, lines=both) == ["info"]
    assert level("LCH007", files) == ["error"]


def test_launch_files_that_are_not_installed_where_pages_start_the_programs() -> None:
    files = {
        "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
        "my_pkg/talker.py": "def main():\n    pass\n",
        "package.xml": manifest(),
        "launch/a.launch.xml": NODE,
    }
    assert level("LCH002", files, PYTHON) == ["info"]
    assert level("LCH002", {**files, "README.md": "ros2 run my_pkg talker\n"}, PYTHON) == ["info"]
    both = "ros2 run my_pkg talker\nros2 launch launch/a.launch.xml\n"
    assert level("LCH002", {**files, "README.md": both}, PYTHON) == ["error"]


def test_a_program_behind_an_argument_that_launch_refuses() -> None:
    node = "Node(package='my_pkg', executable='taker'{})"
    text = EMPTY.replace("([])", f"([{node}])").replace("\n\n\n", "\nfrom launch_ros.actions import Node\n\n\n", 1)
    files = {
        "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
        "my_pkg/talker.py": "def main():\n    pass\n",
        "README.md": "ros2 launch launch/a.launch.py\n",
    }
    assert level("LCH002", {**files, "launch/a.launch.py": text.format("")}, PYTHON) == ["error"]
    old = text.format(", node_name='a'")
    assert level("LCH002", {**files, "launch/a.launch.py": old}, PYTHON) == ["warning"]


def test_another_package_includes_a_file_that_was_not_ported() -> None:
    old = UNPORTED.replace("</launch>", '  <let name="b" value="$(find-pkg-share my_pkg)"/>\n</launch>')
    files = {f"my_pkg/{path}": text for path, text in {**NATIVE, "launch/a.xml": old}.items()}
    install = "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n"
    files |= {
        "my_pkg/CMakeLists.txt": CMAKE.replace("ament_package", f"{install}ament_package"),
        "my_pkg/launch/b.launch.py": EMPTY,
        "other/package.xml": manifest("", "cmake", name="other"),
        "other/launch/o.launch.xml": "<launch>\n</launch>\n",
    }
    assert [each.severity.value for each in lint_files(files, ["LCH006"]).findings] == ["info"]
    files["other/launch/o.launch.xml"] = (
        '<launch>\n  <include file="$(find-pkg-share my_pkg)/launch/a.xml"/>\n</launch>\n'
    )
    assert [each.severity.value for each in lint_files(files, ["LCH006"]).findings] == ["error"]
