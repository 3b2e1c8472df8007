"""A path that only the default of an argument has, which nothing reads, is looked for by nobody: an info."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.finding import Finding
from rospkg_cli.testing import lint_files

NATIVE = existing_files(BACKDROPS["ament_cmake"])
INSTALLS = """\
install(DIRECTORY launch DESTINATION share/my_pkg)
install(FILES maps/home.yaml DESTINATION share/my_pkg/maps)
"""
CMAKE = NATIVE["CMakeLists.txt"].replace("ament_package()", f"{INSTALLS}ament_package()")
NEEDS = "".join(
    f"  <exec_depend>{each}</exec_depend>\n" for each in ("ros2launch", "launch", "nav2_bringup", "other_pkg")
)
MAP = {"maps/office.yaml": "image: office.pgm\n", "maps/office.pgm": "P2 1 1 1 0\n"}
PYTHON = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription, LogInfo, SetLaunchConfiguration
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    share = FindPackageShare('my_pkg')
    path = PathJoinSubstitution([share, 'maps', 'office.yaml'])
    return LaunchDescription([
        DeclareLaunchArgument('map', default_value=path),
        MORE
    ])
"""
INCLUDE = "IncludeLaunchDescription(PythonLaunchDescriptionSource([FindPackageShare('{}'), '/launch/{}'])),"
MARKUP = '<launch>\n  <{} name="map" {}="$(find-pkg-share my_pkg)/maps/office.yaml"/>\n  {}\n</launch>\n'
USES = '<node pkg="a" exec="b" args="$(var map)"/>'
OTHER = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('NAME', default_value='a'), LogInfo(msg=LaunchConfiguration('NAME')),
    ])
"""


def found(files: dict[str, str], there: bool = True) -> list[Finding]:
    base = {**NATIVE, "package.xml": manifest(NEEDS, "ament_cmake"), "CMakeLists.txt": CMAKE}
    files = {**base, "maps/home.yaml": "", **(MAP if there else {}), **files}
    return list(lint_files(files, ["LCH004" if there else "LCH003"]).findings)


def levels(more: str, *, there: bool = True, **others: str) -> list[str]:
    files = {f"launch/{name}.launch.py": text for name, text in others.items()}
    return [e.severity.value for e in found({"launch/robot.launch.py": PYTHON.replace("MORE", more), **files}, there)]


@pytest.mark.parametrize("there", [True, False])
@pytest.mark.parametrize(
    ("more", "level"),
    [
        ("", "info"),
        ("LogInfo(msg=LaunchConfiguration('map')),", "warning"),
        (INCLUDE.format("turtlebot3_gazebo", "empty_world.launch.py"), "info"),
        (INCLUDE.format("nav2_bringup", "bringup_launch.py"), "warning"),
        (INCLUDE.format("nav2_bringup", "rviz_launch.py"), "info"),
        (INCLUDE.format("my_pkg", "other.launch.py"), "info"),
    ],
)
def test_an_argument_is_read_by_the_file_or_by_what_it_includes(more: str, level: str, *, there: bool) -> None:
    assert levels(more, there=there, other=OTHER.replace("NAME", "other")) == [level]


def test_an_include_of_the_workspace_takes_the_argument_or_hands_it_on() -> None:
    more = INCLUDE.format("my_pkg", "other.launch.py")
    assert levels(more, other=OTHER.replace("NAME", "map")) == ["warning"]
    handing = PYTHON.replace("DeclareLaunchArgument('map', default_value=path),", "")
    for package, file, level in (
        ("nav2_bringup", "bringup_launch.py", "warning"),
        ("turtlebot3_gazebo", "empty_world.launch.py", "info"),
        ("my_pkg", "third.launch.py", "warning"),
    ):
        others = {
            "other": handing.replace("MORE", INCLUDE.format(package, file)),
            "third": OTHER.replace("NAME", "map"),
        }
        assert levels(more, **others) == [level]


def test_what_an_argument_says_of_it() -> None:
    (finding,) = found({"launch/robot.launch.py": PYTHON.replace("MORE", "")})
    assert "but nothing uses the argument; install it" in finding.message


@pytest.mark.parametrize("there", [True, False])
@pytest.mark.parametrize(
    ("tag", "value", "more", "level"),
    [
        ("arg", "default", "", "info"),
        ("arg", "default", USES, "warning"),
        ("let", "value", "", "info"),
        ("let", "value", USES, "warning"),
        ("let", "value", '<include file="$(find-pkg-share other_pkg)/launch/a.launch.xml"/>', "info"),
        ("let", "value", '<include file="$(find-pkg-share nav2_bringup)/launch/bringup_launch.py"/>', "warning"),
    ],
)
def test_markup_has_arguments_and_values_that_nothing_reads(
    tag: str, value: str, more: str, level: str, *, there: bool
) -> None:
    files = {"launch/robot.launch.xml": MARKUP.format(tag, value, more)}
    assert [each.severity.value for each in found(files, there)] == [level]


def test_what_may_read_any_argument() -> None:
    for more in (
        "LogInfo(msg=[LaunchConfiguration(each) for each in names()]),",
        "Node(package='a', executable='b', parameters=[ParameterFile('a.yaml', allow_substs=True)]),",
    ):
        assert levels(more) == ["warning"]


COMMENTED = """\
        IncludeLaunchDescription(PythonLaunchDescriptionSource([FindPackageShare('my_pkg'), '/launch/mid.launch.py'])),
        # IncludeLaunchDescription('nav.launch.py', launch_arguments={'map': LaunchConfiguration('map')}.items()),
"""
MIDDLE = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration
from launch_ros.substitutions import FindPackageShare
from lifecycle_msgs.msg import Transition


def generate_launch_description():
    last = PythonLaunchDescriptionSource([FindPackageShare('my_pkg'), '/launch/last.launch.py'])
    return LaunchDescription([
        DeclareLaunchArgument('map', default_value='a'),
        IncludeLaunchDescription(last, launch_arguments={'GIVEN': LaunchConfiguration('map')}.items()),
    ])
"""


@pytest.mark.parametrize(
    ("given", "read", "level"),
    [("map", "other", "info"), ("map", "map", "warning"), ("area", "map", "warning"), ("area", "area", "warning")],
)
def test_what_is_only_handed_on_to_what_ignores_it_is_read_by_nobody(given: str, read: str, level: str) -> None:
    others = {"mid": MIDDLE.replace("GIVEN", given), "last": OTHER.replace("NAME", read)}
    assert levels(COMMENTED, **others) == [level]


@pytest.mark.parametrize(("added", "level"), [("", "info"), ("LogInfo(msg=value)", "warning")])
def test_an_included_file_that_only_puts_the_argument_into_a_variable(added: str, level: str) -> None:
    binds = "    value = LaunchConfiguration('map')\n    return LaunchDescription([\n"
    text = (
        OTHER.replace("    return LaunchDescription([\n", binds)
        .replace("NAME", "other")
        .replace("LogInfo(", f"{added}, LogInfo(" if added else "LogInfo(")
    )
    third = OTHER.replace("NAME", "map")  # that another file has one of the name says nothing
    assert levels(INCLUDE.format("my_pkg", "other.launch.py"), other=text, third=third) == [level]
