"""Files that launch files name: what is read, what is missing, and what can't be told."""

from __future__ import annotations

from collections.abc import Mapping

import pytest
from reading import package

from rospkg_cli.checks.paths.closest_path import closest_path
from rospkg_cli.example import BACKDROPS, CMAKE, SETUP_PY, manifest
from rospkg_cli.finding import Edit
from rospkg_cli.package.launch.launch_file import LaunchFile
from rospkg_cli.testing import lint_files

HEAD = """\
import os
import xacro
from ament_index_python.packages import get_package_prefix, get_package_share_directory, get_package_share_path
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, IncludeLaunchDescription, LogInfo
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import Command, FindExecutable, LaunchConfiguration, PathJoinSubstitution, PathSubstitution
from launch.substitutions import ThisLaunchFileDir
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterFile
from launch_ros.substitutions import FindPackagePrefix, FindPackageShare
from moveit_configs_utils import MoveItConfigsBuilder


def generate_launch_description():
"""
INSTALL = CMAKE.replace(
    "ament_package", "install(DIRECTORY launch config DESTINATION share/${PROJECT_NAME})\nament_package"
)
YAML = "/**:\n  ros__parameters:\n    rate: 2.0\n"
BASE = {
    "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
    "CMakeLists.txt": INSTALL,
    "config/robot.yaml": YAML,
}
CODES = ["LCH002", "LCH003", "LCH004", "LCH005", "LCH006", "LCH012"]


def python(body: str) -> str:
    return HEAD + "".join(f"    {line}\n" for line in body.splitlines())


def named(path: str, text: str) -> set[tuple[str, str, str]]:
    """Return package, path and use of every file that a launch file names."""
    (file,) = package({path: text}).parts(LaunchFile).good
    return {(each.package, each.path, each.use) for each in file.paths}


@pytest.mark.parametrize(
    "body",
    [
        "FindPackageShare('a').find(name) + '/y.yaml'",
        "MoveItConfigsBuilder('r', package_name='a').sensors_3d('y.yaml')",
        "MoveItConfigsBuilder('r', package_name=name).joint_limits('y.yaml')",
        "OtherBuilder('r', package_name='a').joint_limits('y.yaml')",
    ],
)
def test_what_is_looked_for_first_or_elsewhere_is_not_named(body: str) -> None:
    assert not named("launch/robot.launch.py", python(f"Node(parameters=[{body}])"))


def test_the_package_of_a_builder_may_be_called_like_the_robot() -> None:
    found = named("launch/robot.launch.py", python("MoveItConfigsBuilder('arm').joint_limits('y.yaml')"))
    assert found == {("arm_moveit_config", "y.yaml", "open")}


def said(files: Mapping[str, str], *codes: str) -> list[str]:
    return [f"{f.code} {f.severity.value}" for f in lint_files(files, codes or CODES).findings]


@pytest.mark.parametrize(
    "body, path, use",
    [
        ("Node(parameters=[os.path.join(get_package_share_directory('a'), 'x', 'y.yaml')])", "x/y.yaml", "file"),
        ("Node(parameters=[{'f': get_package_share_directory('a') + '/y.yaml'}])", "y.yaml", "file"),
        ("Node(arguments=['-d', PathJoinSubstitution([FindPackageShare('a'), 'y.rviz'])])", "y.rviz", "file"),
        ("Node(parameters=[ParameterFile([FindPackageShare('a'), '/y.yaml'])])", "y.yaml", "file"),
        ("Node(parameters=[get_package_share_path('a') / 'x' / 'y.yaml'])", "x/y.yaml", "file"),
        ("Node(parameters=[get_package_prefix('a') + '/share/a/y.yaml'])", "y.yaml", "file"),
        ("Node(parameters=[os.path.join(FindPackageShare(package='a').find('a'), 'y.yaml')])", "y.yaml", "file"),
        ("Node(parameters=[FindPackageShare('b').find('a') + '/y.yaml'])", "y.yaml", "file"),
        ("Node(parameters=[FindPackagePrefix('a').find('a') + '/share/a/y.yaml'])", "y.yaml", "file"),
        ("MoveItConfigsBuilder('r', package_name='a').robot_description_semantic('y.srdf')", "y.srdf", "open"),
        (
            "MoveItConfigsBuilder('r', package_name='a').joint_limits(file_path='x/y.yaml').moveit_cpp()",
            "x/y.yaml",
            "open",
        ),
        ("MoveItConfigsBuilder('r', package_name='a').robot_description(file_path='y.xacro')", "y.xacro", "file"),
        ("Command(['xacro ', FindPackageShare('a'), '/y.xacro', ' b:=1'])", "y.xacro", "open"),
        ("Command(['xacro x.xacro b:=', FindPackageShare('a'), '/y.yaml'])", "y.yaml", "file"),
        ("Command(['xacro x.xacro b:=\\'', FindPackageShare('a'), '/y.yaml'])", "y.yaml", "file"),
        ("Command([FindExecutable(name='xacro'), ' ', FindPackageShare('a'), '/y.xacro'])", "y.xacro", "open"),
        ("Command(['/opt/bin/xacro ', FindPackageShare('a'), '/y.xacro'])", "y.xacro", "open"),
        ("Command(['ros2 run xacro xacro ', FindPackageShare('a'), '/y.xacro'])", "y.xacro", "open"),
        ("Command(['cat ', FindPackageShare('a'), '/y.urdf'])", "y.urdf", "open"),
        ("Command(['tool ', FindPackageShare('a'), '/y.urdf'])", "y.urdf", "file"),
        ("xacro.process_file(get_package_share_directory('a') + '/y.urdf')", "y.urdf", "open"),
        ("Node(parameters=[PathSubstitution(FindPackageShare('a')) / 'y.yaml'])", "y.yaml", "file"),
        ("DeclareLaunchArgument('p', default_value=get_package_share_directory('a') + '/y.yaml')", "y.yaml", "default"),
        ("IncludeLaunchDescription([FindPackageShare('a'), '/y.launch.py'])", "y.launch.py", "include"),
        ("PythonLaunchDescriptionSource([FindPackageShare('a'), '/y.launch.py'])", "y.launch.py", "include"),
        ("ExecuteProcess(cmd=['sh', '-c', ['(cat ', FindPackageShare('a'), '/y.urdf)']])", "y.urdf", "file"),
        ("ExecuteProcess(cmd=['cat', [FindPackageShare('a'), '/y.urdf']])", "y.urdf", "file"),
        ("open(os.path.join(get_package_share_directory('a'), 'y.urdf')).read()", "y.urdf", "open"),
    ],
)
def test_files_of_a_package_are_found_in_python(body: str, path: str, use: str) -> None:
    assert named("launch/a.launch.py", python(f"return LaunchDescription([{body}])")) == {("a", path, use)}


@pytest.mark.parametrize(
    "body",
    [
        "Node(parameters=[os.path.join(get_package_share_directory('a'), 'maps')])",
        "Node(parameters=[[FindPackageShare('a'), '/', LaunchConfiguration('file'), '.yaml']])",
        "Node(parameters=[[FindPackageShare('a'), '/x.', LaunchConfiguration('suffix')]])",
        "Node(parameters=[os.path.join(get_package_share_directory('a'), '..', 'b', 'y.yaml')])",
        "Node(parameters=[get_package_prefix('a') + '/lib/a/y.py'])",
        "Node(parameters=[get_package_share_directory(os.environ['P']) + '/y.yaml'])",
        "Node(parameters=[{'log': get_package_share_directory('a') + '/logs/y.yaml'}])",
        "open(get_package_share_directory('a') + '/y.yaml', 'w')",
        "LogInfo(msg=['(', FindPackageShare('a'), '/y.yaml)'])",
        "os.path.join(get_package_share_directory('a'), 'y.yaml')",
    ],
)
def test_what_is_a_folder_or_not_literal_or_written_is_left_alone(body: str) -> None:
    assert named("launch/a.launch.py", python(f"return LaunchDescription([{body}])")) == set()


@pytest.mark.parametrize(
    "body",
    [
        "p = get_package_share_directory('a') + '/y.yaml'\nif os.path.exists(p):\n    return Node(parameters=[p])",
        "p = get_package_share_path('a') / 'y.yaml'\nif p.exists():\n    return Node(parameters=[p])",
        "try:\n    return open(get_package_share_directory('a') + '/y.yaml')\nexcept OSError:\n    return None",
    ],
)
def test_a_file_that_is_asked_for_first_may_be_missing(body: str) -> None:
    assert named("launch/a.launch.py", python(body)) == set()


def test_files_are_found_in_xml_and_beside_the_launch_file() -> None:
    text = (
        '<launch><arg name="a" default="$(find-pkg-share a)/y.yaml"/><include file="$(dirname)/b.launch.xml"/>'
        '<let name="d" value="$(command \'xacro $(find-pkg-share a)/z.xacro x:=1\')"/></launch>'
    )
    beside = ("", "launch/b.launch.xml", "include")
    assert named("launch/a.launch.xml", text) == {("a", "y.yaml", "default"), ("a", "z.xacro", "open"), beside}
    body = "return IncludeLaunchDescription(os.path.join(os.path.dirname(__file__), 'b.launch.py'))"
    assert named("launch/a.launch.py", python(body)) == {("", "launch/b.launch.py", "include")}
    body = "return IncludeLaunchDescription([ThisLaunchFileDir(), '/../config/b.launch.py'])"
    assert named("launch/a.launch.py", python(body)) == {("", "config/b.launch.py", "include")}


def test_files_beside_are_looked_for_where_the_launch_file_stands_and_where_it_goes() -> None:
    text = '<launch>\n  <include file="$(dirname)/b.launch.xml"/>\n</launch>\n'
    files = {**BASE, "launch/a.launch.xml": text}
    assert said(files) == ["LCH003 error"]
    assert said({**files, "launch/b.launch.xml": "<launch/>"}) == []
    flat = INSTALL.replace("launch config", "launch/ config/ more/")
    assert said({**files, "CMakeLists.txt": flat, "more/b.launch.xml": "<launch/>"}) == []


def test_what_other_packages_install_is_known() -> None:
    other = {f"other/{path}": text.replace("my_pkg", "other") for path, text in BASE.items()}
    launch = '<launch>\n  <include file="$(find-pkg-share other)/{}"/>\n</launch>\n'

    def finds(path: str, **more: str) -> list[str]:
        own = {f"my_pkg/{name}": text for name, text in BASE.items()}
        return said({**own, **other, "my_pkg/launch/a.launch.xml": launch.format(path), **more}, "LCH003", "LCH004")

    assert finds("config/robot.yaml") == []
    assert finds("config/robots.yaml") == ["LCH003 error"]
    one = INSTALL.replace("my_pkg", "other").replace("DIRECTORY launch config", "FILES config/robot.yaml")
    more = {"other/CMakeLists.txt": one.replace("NAME}", "NAME}/config"), "other/config/more.yaml": YAML}
    assert finds("config/more.yaml", **more) == ["LCH004 error"]
    more["other/CMakeLists.txt"] = one.replace("config/robot.yaml", "${FILES_OF}")
    assert finds("config/more.yaml", **more) == []


@pytest.mark.parametrize(
    "line",
    [
        "configure_file(config/made.yaml.in ${CMAKE_CURRENT_SOURCE_DIR}/config/made.yaml)",
        "configure_file(config/made.yaml.in ${CMAKE_CURRENT_SOURCE_DIR}/config/${NAME}.yaml)",
        "execute_process(COMMAND xacro config/made.xacro -o ${CMAKE_CURRENT_SOURCE_DIR}/config/made.yaml)",
        "xacro_add_files(config/made.yaml.xacro INSTALL DESTINATION config)",
        "install(DIRECTORY submodule/config DESTINATION share/${PROJECT_NAME})",
    ],
)
def test_what_the_build_writes_may_be_missing(line: str) -> None:
    launch = '<launch>\n  <include file="$(find-pkg-share my_pkg)/config/made.yaml"/>\n</launch>\n'
    files = {**BASE, "launch/a.launch.xml": launch}
    assert said(files) == ["LCH003 error"]
    assert said({**files, "CMakeLists.txt": INSTALL.replace("ament_package", f"{line}\nament_package")}) == []


def test_of_what_is_installed_and_not_there_cmake_speaks() -> None:
    launch = '<launch><node pkg="my_pkg" exec="run"/><include file="$(find-pkg-share my_pkg)/no.yaml"/></launch>'
    lines = "install(PROGRAMS scripts/run DESTINATION lib/my_pkg)\ninstall(FILES no.yaml DESTINATION share/my_pkg)\n"
    files = {**BASE, "launch/a.launch.xml": launch}
    assert said(files) == ["LCH002 error", "LCH003 error"]
    files["CMakeLists.txt"] = INSTALL.replace("ament_package", f"{lines}ament_package")
    assert said(files, *CODES, "CMK102") == ["CMK102 error", "CMK102 error"]


def test_a_default_may_be_given_anew() -> None:
    launch = '<launch>\n  <arg name="a" default="$(find-pkg-share my_pkg)/config/no.yaml"/>\n</launch>\n'
    assert said({**BASE, "launch/a.launch.xml": launch}) == ["LCH003 info"]
    used = launch.replace("</launch>", '  <log message="$(var a)"/>\n</launch>')
    assert said({**BASE, "launch/a.launch.xml": used}) == ["LCH003 warning"]


def test_what_an_argument_is_by_default_is_put_in_its_place() -> None:
    named_by = '<let name="f" value="$(find-pkg-share my_pkg)/config/$(var robot).yaml"/>'

    def finds(default: str, more: str = "") -> list[str]:
        launch = f'<launch>{more}<arg name="robot" {default}/>{named_by}</launch>'
        return said({**BASE, "launch/a.launch.xml": launch})

    assert finds('default="robot"') == []
    assert finds('default="rover"') == ["LCH003 warning"]
    assert finds("") == finds('default="$(env ROBOT)"') == []
    assert finds('default="rover"', '<let name="robot" value="robot"/>') == []
    share = "PathJoinSubstitution([FindPackageShare('my_pkg'), 'config', LaunchConfiguration('robot')])"
    body = f"return [DeclareLaunchArgument('robot', default_value='rover.yaml'), Node(parameters=[{share}])]"
    assert said({**BASE, "launch/a.launch.py": python(body)}) == ["LCH003 warning"]
    share = "PathSubstitution(FindPackageShare(LaunchConfiguration('pkg'))) / 'config' / LaunchConfiguration('name')"
    arguments = (
        "DeclareLaunchArgument('pkg', default_value='my_pkg'), DeclareLaunchArgument('name', default_value='{}')"
    )
    body = f"return [{arguments}, Node(parameters=[{share} / 'robot.yaml'])]"
    assert said({**BASE, "launch/a.launch.py": python(body.format("."))}) == []
    assert said({**BASE, "launch/a.launch.py": python(body.format("rover"))}) == ["LCH003 warning"]


def test_a_missing_slash_is_seen_where_the_file_is_there() -> None:
    body = "return Node(parameters=[get_package_share_directory('my_pkg') + '{}'])"
    assert said({**BASE, "launch/a.launch.py": python(body.format("config/robot.yaml"))}) == ["LCH003 warning"]
    assert said({**BASE, "launch/a.launch.py": python(body.format("_more/robot.yaml"))}) == []


def test_one_file_that_is_missing_is_one_finding() -> None:
    line = '  <include file="$(find-pkg-share my_pkg)/launch/b.launch.xml"/>\n'
    (found,) = lint_files({**BASE, "launch/a.launch.xml": f"<launch>\n{line * 3}</launch>\n"}, CODES).findings
    assert len(found.related) == 2


def test_of_a_folder_that_stays_behind_its_own_rule_speaks() -> None:
    launch = '<launch>\n  <include file="$(find-pkg-share my_pkg)/config/robot.yaml"/>\n</launch>\n'
    files = {**BASE, "launch/a.launch.xml": launch, "CMakeLists.txt": INSTALL.replace("launch config", "launch")}
    assert said(files, "CMK101", "LCH003", "LCH004") == ["CMK101 error"]
    renamed = INSTALL.replace("launch config", "launch").replace(
        "ament_package", "install(FILES config/robot.yaml DESTINATION share/${PROJECT_NAME})\nament_package"
    )
    assert said({**files, "CMakeLists.txt": renamed}, "CMK101", "LCH003", "LCH004") == ["LCH004 error"]


def test_a_launch_test_that_cmake_does_not_run_is_left_alone() -> None:
    launch = python("return LaunchDescription([Node(package='my_pkg', executable='no')])")
    files = {**BASE, "test/no_launch_test.launch.py": launch}
    assert said(files) == []
    named_there = INSTALL.replace("ament_package", "add_launch_test(test/no_launch_test.launch.py)\nament_package")
    assert said({**files, "CMakeLists.txt": named_there}) == ["LCH002 error"]


@pytest.mark.parametrize(
    "started, built, meant",
    [
        ("planner", "my_pkg_planner_node", "my_pkg_planner_node"),
        ("my_pkg_planner_node", "planner", "planner"),
        ("planner", "my_pkg_planner_node my_pkg_planner_tool", None),
        ("planner", "driver", None),
    ],
)
def test_what_a_rename_left_is_told(started: str, built: str, meant: str | None) -> None:
    lines = "".join(f"add_executable({each} a.cpp)\n" for each in built.split())
    rule = f"{lines}install(TARGETS {built} DESTINATION lib/my_pkg)\nament_package"
    files = {
        **BASE,
        "CMakeLists.txt": CMAKE.replace("ament_package", rule),
        "launch/a.launch.xml": f'<launch><node pkg="my_pkg" exec="{started}"/></launch>',
    }
    (found,) = lint_files(files, ["LCH002"]).findings
    assert (f"did you mean `{meant}`?" in found.message) == (found.fix is not None) == (meant is not None)


def test_a_launch_file_that_is_not_installed_is_no_idle_test() -> None:
    launch = python("return LaunchDescription([Node(package='my_pkg', executable='no')])")
    files = {**BASE, "CMakeLists.txt": CMAKE, "launch/a.launch.py": launch}
    assert said(files) == ["LCH002 info"]
    assert said({**files, "README.md": "ros2 launch launch/a.launch.py\n"}) == ["LCH002 error"]


def test_old_arguments_are_left_where_the_distro_is_asked_for() -> None:
    both = (
        "if os.environ['ROS_DISTRO'] == 'dashing':\n    return Node(node_executable='x')\nreturn Node(executable='x')"
    )
    assert said({**BASE, "launch/a.launch.py": python(both)}) == []
    assert said({**BASE, "launch/a.launch.py": python("return Node(node_executable='x')")}) == ["LCH005 info"]
    twice = lint_files({**BASE, "launch/a.launch.py": python("return Node(node_name='x', name='x')")}, ["LCH005"])
    assert [f.fix for f in twice.findings] == [None]


@pytest.mark.parametrize(
    "text, found",
    [
        ('<launch><node pkg="a" type="b"/></launch>', ["LCH006 info"]),
        ('<launch><node pkg="a" type="b" args="$(var x)"/></launch>', ["LCH005 error"]),
        ('<launch><let name="a" value="$(find b)/$(arg c)"/></launch>', ["LCH006 error", "LCH006 error"]),
        ('<launch><let name="a" value="b"/><rosparam file="c"/></launch>', ["LCH006 error"]),
        ('<launch><node pkg="a" exec="b"><param name="c" value="d"/></node></launch>', []),
    ],
)
def test_what_only_ros1_knows(text: str, found: list[str]) -> None:
    assert said({**BASE, "launch/a.launch.xml": text}, "LCH005", "LCH006", "LCH007") == found
    plain = {**BASE, "launch/a.launch.xml": text, "CMakeLists.txt": CMAKE}
    assert [each for each in said(plain, "LCH006") if each.endswith("warning")] == []


def test_a_launch_file_that_others_include_by_its_path_is_no_double() -> None:
    empty = "<launch/>"
    files = {**BASE, "launch/a/robot.launch.xml": empty, "launch/b/robot.launch.xml": empty}
    assert said(files) == ["LCH012 warning"]
    lines = [f'<include file="$(find-pkg-share my_pkg)/launch/{each}/robot.launch.xml"/>' for each in "ab"]
    assert said({**files, "launch/all.launch.xml": f"<launch>{''.join(lines)}</launch>"}) == []


def test_tests_and_parts_may_be_called_otherwise() -> None:
    text = python("return LaunchDescription([Node(package='a', executable='b')])")
    files = {**BASE, "launch/robot.py": text, "launch/test/robot.py": text}
    findings = lint_files(files, ["LCH010"]).findings
    assert [f.location.path for f in findings] == ["launch/robot.py"]
    whole = '<launch><include file="$(find-pkg-share my_pkg)/launch/robot.py"/></launch>'
    assert said({**files, "launch/all.launch.xml": whole}, "LCH010") == []


@pytest.mark.parametrize("name", ["robot.py", "robot.launch.py.py", "robot.launch.launch.py.py"])
def test_a_better_name_ends_once(name: str) -> None:
    text = python("return LaunchDescription([Node(package='a', executable='b')])")
    (found,) = lint_files({**BASE, f"launch/{name}": text}, ["LCH010"]).findings
    assert found.message.endswith("rename it to `robot.launch.py`")


def include(*arguments: str) -> str:
    given = "".join(f'<arg name="{name}" value="1"/>' for name in arguments)
    return f'<launch><include file="$(find-pkg-share my_pkg)/launch/arm.launch.xml">{given}</include></launch>'


@pytest.mark.parametrize(
    "inner, given, found",
    [
        ('<arg name="a"/><let name="b" value="$(var a)"/>', ["a"], []),
        ('<arg name="a"/><let name="b" value="$(var a)"/>', [], ["a"]),
        ('<arg name="a" default="1"/><let name="b" value="$(var a)"/>', ["b"], ["b"]),
        ('<let name="b" value="$(var a)"/>', ["a"], []),
        ('<arg name="a" if="$(env X)"/><let name="b" value="$(var a)"/>', [], []),
        ('<node pkg="p" exec="e"><param from="/x.yaml" allow_substs="true"/></node>', ["a"], []),
        ('<include file="$(find-pkg-share my_pkg)/launch/hand.launch.xml"/>', ["finger"], []),
        ('<include file="$(find-pkg-share my_pkg)/launch/hand.launch.xml"/>', ["toe"], ["toe"]),
        ('<include file="$(find-pkg-share elsewhere)/launch/hand.launch.xml"/>', ["toe"], []),
        ('<include file="$(var which)"/>', ["toe"], []),
    ],
)
def test_what_an_include_gives_is_what_the_file_takes(inner: str, given: list[str], found: list[str]) -> None:
    hand = '<launch><arg name="finger" default="1"/><let name="b" value="$(var finger)"/></launch>'
    files = {
        **BASE,
        "launch/arm.launch.xml": f"<launch>{inner}</launch>",
        "launch/hand.launch.xml": hand,
        "launch/robot.launch.xml": include(*given),
    }
    findings = [f for f in lint_files(files, ["LCH015"]).findings if f.location.path == "launch/robot.launch.xml"]
    assert [name for f in findings for name in found if f"`{name}`" in f.message] == found
    assert len(findings) == len(found)


@pytest.mark.parametrize(
    "given, found",
    [
        (["speeed"], True),
        (["speeed", "speed"], False),
        (["speed"], False),
        (["sped"], False),
        (["speed_limits"], False),
        (["camera_2"], False),
        (["fingers"], False),
    ],
)
def test_a_mistyped_argument_of_a_file_that_includes_what_is_not_here(given: list[str], found: bool) -> None:
    outer = '<include file="$(find-pkg-share elsewhere)/launch/a.launch.xml"/>'
    inner = '<include file="$(find-pkg-share my_pkg)/launch/hand.launch.xml"/>'
    declared = "".join(f'<arg name="{name}" default="1"/>' for name in ("speed", "camera_1", "finger", "fed"))
    files = {
        **BASE,
        "launch/arm.launch.xml": f"<launch>{declared}{outer}{inner}</launch>",
        "launch/hand.launch.xml": '<launch><arg name="fingers" default="1"/></launch>',
        "launch/robot.launch.xml": include(*given),
    }
    findings = [f for f in lint_files(files, ["LCH015"]).findings if f.location.path == "launch/robot.launch.xml"]
    assert [f.severity.value for f in findings] == ["info"] * found


@pytest.mark.parametrize(
    "body, found",
    [
        ("return LaunchDescription([DeclareLaunchArgument('a')])", 1),
        ("def late(context):\n    return [DeclareLaunchArgument('a')]\nreturn OpaqueFunction(function=late)", 0),
        ("if os.environ.get('X'):\n    return DeclareLaunchArgument('a')\nreturn []", 0),
        ("return [DeclareLaunchArgument('a', default_value='1')]", 0),
    ],
)
def test_only_what_is_declared_for_certain_is_required(body: str, found: int) -> None:
    arm = python("from launch.actions import OpaqueFunction\n" + body)
    text = include().replace("arm.launch.xml", "arm.launch.py")
    files = {**BASE, "launch/arm.launch.py": arm, "launch/robot.launch.xml": text}
    assert said(files, "LCH015") == ["LCH015 warning"] * found
    more = arm.replace("return", "context.launch_configurations['b']\n    return", 1)
    given = include("b").replace("arm.launch.xml", "arm.launch.py")
    assert [
        f
        for f in lint_files(
            {**files, "launch/arm.launch.py": more, "launch/robot.launch.xml": given}, ["LCH015"]
        ).findings
        if "`b`" in f.message
    ] == []


PYTHON_BASE = {**BACKDROPS["ament_python"], "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n")}
NAMES_IT = '<launch>\n  <include file="$(find-pkg-share my_pkg)/config/robot.yaml"/>\n</launch>\n'
SHARE = "        ('share/' + package_name, ['package.xml']),\n"


def with_setup(line: str) -> dict[str, str]:
    files = {path: text for path, text in PYTHON_BASE.items() if text is not None}
    launch = "        ('share/' + package_name + '/launch', ['launch/a.launch.xml']),\n"
    setup = SETUP_PY.replace(SHARE, SHARE + launch + line)
    return {**files, "setup.py": setup, "launch/a.launch.xml": NAMES_IT, "config/robot.yaml": YAML}


def test_of_a_folder_that_setup_py_forgets_its_own_rule_speaks() -> None:
    assert said(with_setup(""), "SET206", "LCH003", "LCH004") == ["SET206 error"]


def test_a_file_that_setup_py_leaves_out_is_put_beside_its_like() -> None:
    files = {
        **with_setup("        ('share/' + package_name + '/config', ['config/more.yaml']),\n"),
        "config/more.yaml": YAML,
    }
    (found,) = lint_files(files, ["SET206", "SET207", "LCH003", "LCH004"]).findings
    assert found.code == "LCH004"
    assert found.fix is not None
    assert [each.text for each in found.fix.operations if isinstance(each, Edit)] == ["', 'config/robot.yaml'"]


@pytest.mark.parametrize(
    "started, told",
    [
        ("'run.py'", "install `lib/my_pkg/tools/run.py` into `lib/my_pkg` itself"),
        ("'tools/run.py'", "install `lib/my_pkg/tools/run.py` into `lib/my_pkg` itself"),
        ("'rum.py'", "it installs `talker`"),
        ("'/opt/run.py'", ""),
        ("os.path.join(os.path.dirname(os.path.dirname(os.path.realpath(__file__))), 'tools', 'run.py')", ""),
    ],
)
def test_launch_looks_into_no_folder_of_the_executables(started: str, told: str) -> None:
    launch = python(f"return LaunchDescription([Node(package='my_pkg', executable={started})])")
    rules = (
        "install(PROGRAMS tools/run.py DESTINATION lib/my_pkg/tools)\ninstall(PROGRAMS talker DESTINATION lib/my_pkg)\n"
    )
    files = {
        **BASE,
        "CMakeLists.txt": INSTALL.replace("ament_package", f"{rules}ament_package"),
        **dict.fromkeys(("tools/run.py", "talker"), "#!/usr/bin/env python3\nprint()\n"),
        "launch/a.launch.py": f"import os\n{launch}",
    }
    found = lint_files(files, ["LCH002"]).findings
    assert [told in each.message for each in found] == ([True] if told else [])


def test_what_xacro_writes_for_the_launch_file_may_be_missing() -> None:
    path = "get_package_share_directory('my_pkg') + '/config/no.urdf'"
    body = "path = {}\n{}return LaunchDescription([Node(package='my_pkg', executable='a', arguments=['-file', path])])"
    for writes, expected in (("", ["LCH003 warning"]), ("out = xacro.open_output(path)\nout.write('')\n", [])):
        launch = python(body.format(path, writes))
        assert said({**BASE, "launch/a.launch.py": f"import xacro\n{launch}"}, "LCH003") == expected


@pytest.mark.parametrize("own, expected", [("", []), ("add_executable(b a.cpp)\n", ["LCH002 error"])])
def test_a_macro_of_elsewhere_may_make_all_programs(own: str, expected: list[str]) -> None:
    launch = '<launch><node pkg="my_pkg" exec="talker"/></launch>\n'
    lines = INSTALL.replace("ament_package", f"{own}include(${{TEAM}}/all.cmake)\nteam_begin(core)\nament_package")
    assert said({**BASE, "CMakeLists.txt": lines, "launch/a.launch.xml": launch}, "LCH002") == expected


@pytest.mark.parametrize(
    ("path", "found"),
    [
        ("os.path.join(os.getcwd(), 'src', 'my_pkg', 'config', 'none.yaml')", 0),
        ("os.path.join(os.path.abspath('src/my_pkg'), 'config', 'none.yaml')", 0),
        ("str(pathlib.Path.cwd() / 'config' / 'none.yaml')", 0),
        ("os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'config', 'none.yaml')", 1),
    ],
)
def test_where_a_launch_is_started_is_not_known(path: str, found: int) -> None:
    text = python(f"    return LaunchDescription([Node(package='my_pkg', executable='a', parameters=[{path}])])")
    assert len(said({**BASE, "launch/a.launch.py": f"import pathlib\n{text}"}, "LCH003")) == found


@pytest.mark.parametrize(
    ("lines", "level"),
    [
        ("", "warning"),
        ("text = open(path).read()\n", "error"),
        ("Command(['xacro ', path])\n", "error"),
        ("DeclareLaunchArgument('a', default_value=path)\n", "warning"),
    ],
)
def test_the_surest_use_of_a_missing_file_counts(lines: str, level: str) -> None:
    path = "path = get_package_share_directory('my_pkg') + '/config/no.urdf'\n"
    body = f"{path}{lines}return LaunchDescription([Node(package='my_pkg', executable='a', arguments=['-file', path])])"
    assert said({**BASE, "launch/a.launch.py": python(body)}, "LCH003") == [f"LCH003 {level}"]


@pytest.mark.parametrize(
    ("there", "missing", "is_meant"),
    [
        ("robot_config", "robto_config", True),
        ("robot_config", "robot.config", True),
        ("robot_config", "Robot_Config", True),
        ("robot_config", "my_robot_config", True),
        ("robot_config", "config", True),
        ("left_wheel_config", "wheels_config", False),
        ("nav_config", "slam_config", False),
        ("robot_config_1", "robot_config_2", False),
        ("robot_config_l", "robot_config_r", False),
        ("robot_config_left", "robot_config_right", False),
        ("map_config", "mask_config", False),
    ],
)
def test_a_sibling_is_not_meant(there: str, missing: str, is_meant: bool) -> None:
    known = [f"config/{there}.yaml", "launch/a.launch.py"]
    assert closest_path(f"config/{missing}.yaml", known) == (known[0] if is_meant else None)


def test_a_file_of_another_kind_may_be_meant() -> None:
    assert closest_path("worlds/big_house.world", ["worlds/big_house.sdf"]) == "worlds/big_house.sdf"


def test_a_file_that_is_included_is_not_meant_as_itself() -> None:
    def suggested(name: str) -> str:
        text = '<launch><include file="$(find-pkg-share my_pkg)/launch/robott.launch.xml"/></launch>\n'
        files = {**BASE, f"launch/{name}.launch.xml": text, "launch/wheels_driver_of_all.launch.xml": "<launch/>\n"}
        (finding,) = lint_files(files, ["LCH003"]).findings
        return finding.message.partition("did you mean `")[2].partition("`")[0]

    assert suggested("robot") == ""


@pytest.mark.parametrize(
    ("given", "found"),
    [
        ("param_file", ["`bringup_launch.py` of `nav2_bringup` takes no argument `param_file`"]),
        ("params_file", []),
        ("own_option", []),
        ("mpa", []),
    ],
)
def test_a_slip_in_an_argument_of_a_well_known_launch_file(given: str, found: list[str]) -> None:
    text = include(given).replace("my_pkg)/launch/arm.launch.xml", "nav2_bringup)/launch/bringup_launch.py")
    said = lint_files({**BASE, "launch/robot.launch.xml": text}, ["LCH015"]).findings
    assert [(each.severity.value, each.message.partition(":")[0]) for each in said] == [
        ("warning", one) for one in found
    ]


SETS = "def late(context):\n    context.launch_configurations{}\n    return []\n\n\n"


@pytest.mark.parametrize(
    ("before", "action", "level"),
    [
        ("", "LogInfo(msg='a')", "warning"),
        ("", "SetLaunchConfiguration('params', 'b.yaml')", "info"),
        ("", "SetLaunchConfiguration('other', 'b.yaml')", "warning"),
        (SETS.format("['params'] = 'b.yaml'"), "OpaqueFunction(function=late)", "info"),
        (SETS.format(".update({'params': 'b.yaml'})"), "OpaqueFunction(function=late)", "info"),
        (SETS.format("['other'] = 'b.yaml'"), "OpaqueFunction(function=late)", "warning"),
        (SETS.format(".get('params')"), "OpaqueFunction(function=late)", "warning"),
    ],
)
def test_the_default_of_an_argument_that_the_file_itself_sets(before: str, action: str, level: str) -> None:
    body = f"""\
    path = os.path.join(get_package_share_directory('my_pkg'), 'config', 'absent.yaml')
    params = LaunchConfiguration('params')
    node = Node(package='a', executable='b', parameters=[params])
    return LaunchDescription([DeclareLaunchArgument('params', default_value=path), {action}, node])
"""
    start, _, end = HEAD.rpartition("def generate")
    imports = "from launch.actions import OpaqueFunction, SetLaunchConfiguration\n"
    text = f"{imports}{start}{before}def generate{end}{body}"
    assert said({**BASE, "launch/a.launch.py": text}, "LCH003") == [f"LCH003 {level}"]
    both = text.replace("parameters=[params]", "parameters=[path]")
    assert said({**BASE, "launch/a.launch.py": both}, "LCH003") == ["LCH003 warning"]
    xml = """\
<launch>
  <arg name="params" default="$(find-pkg-share my_pkg)/config/absent.yaml"/>
  {}<node pkg="a" exec="b"><param from="$(var params)"/></node>
</launch>
"""
    for line, wanted in (("", "warning"), ('<let name="params" value="b.yaml"/>', "info")):
        assert said({**BASE, "launch/a.launch.xml": xml.format(line)}, "LCH003") == [f"LCH003 {wanted}"]


@pytest.mark.parametrize(
    ("path", "level", "hint"),
    [
        ("ur_bringup)/launch/ur_moveit.launch.py", "warning", "`launch/ur_moveit.launch.py` of `ur_moveit_config`?"),
        ("nav2_bringup)/launch/bringup.launch.py", "warning", "did you mean `launch/bringup_launch.py`?"),
        ("nav2_bringup)/launch/something_else.launch.py", "", ""),
        ("nav2_bringup)/launch/bringup_launch.py", "", ""),
        ("nav2_bringup)/launch/something_else.py", "", ""),
        ("somebodys_package)/launch/ur_moveit.launch.py", "", ""),
    ],
)
def test_a_launch_file_that_a_well_known_package_does_not_have(path: str, level: str, hint: str) -> None:
    text = f'<launch><include file="$(find-pkg-share {path}"/></launch>\n'
    said = lint_files({**BASE, "launch/robot.launch.xml": text}, ["LCH003"]).findings
    assert [each.severity.value for each in said] == ([level] if level else [])
    assert all(hint in each.message for each in said)


def test_a_part_of_a_name_that_stands_twice_where_a_macro_may_install_more() -> None:
    text = "<launch><node pkg='my_pkg' exec='n'><param from='$(find-pkg-share my_pkg)/config/{}'/></node></launch>\n"
    files = {
        "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": "project(my_pkg)\nfind_package(ament_cmake REQUIRED)\nfind_package(others REQUIRED)\n"
        "others_set_options()\n"
        "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\nament_package()\n",
        "config/a.param.yaml": "/**:\n  ros__parameters:\n    a: 1\n",
    }

    def told(name: str) -> list[str]:
        return [
            each.message
            for each in lint_files({**files, "launch/a.launch.xml": text.format(name)}, ["LCH003"]).findings
        ]

    assert "did you mean `config/a.param.yaml`?" in told("a.param.param.yaml")[0]
    assert told("a.param.yaml") == []


MESHES = ["meshes/visual/base.stl", "meshes/visual/arm.stl", "meshes/collision/base.stl", "meshes/collision/arm.stl"]
ROBOTS = ["arms/fer/visual/link0.dae", "arms/fer/visual/link1.dae", "arms/fp3/visual/link1.dae", "arms/old/link9.dae"]


@pytest.mark.parametrize(
    ("path", "known", "meant"),
    [
        ("meshes/visual/arm.stl", [*MESHES[:1], *MESHES[2:]], None),
        ("meshes/visual/arm.stl", ["meshes/visual/base.dae", *MESHES[2:]], "meshes/collision/arm.stl"),
        ("meshs/visual/arm.stl", MESHES, "meshes/visual/arm.stl"),
        ("visual/arm.stl", MESHES, "meshes/visual/arm.stl"),
        ("meshes/visual/arm.stl", ["meshes/arm.stl"], "meshes/arm.stl"),
        ("meshes/arm.stl", MESHES, None),
        ("arms/fp3/visual/link0.dae", ROBOTS, None),
        ("arms/fr3/visual/link1.dae", ["arms/fer/visual/link1.dae", "arms/panda/visual/link1.dae"], None),
        ("arms/fp3/visual/link9.dae", ROBOTS, "arms/old/link9.dae"),
    ],
)
def test_folders_with_the_same_names_are_not_taken_for_each_other(path: str, known: list[str], meant) -> None:
    """`collision/` has other things by the names of `visual/`, and so has the folder of another robot."""
    assert closest_path(path, known) == meant
