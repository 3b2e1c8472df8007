"""LCH003: files that something writes when the launch runs, and those that a plain launch does not read."""

from __future__ import annotations

import pytest
from test_launch_references import BASE, HEAD

from rospkg_cli.testing import lint_files

SHARE = "share = get_package_share_directory('my_pkg')\n"
CONDITIONS = "from launch.conditions import IfCondition, UnlessCondition\n"


def levels(body: str) -> list[str]:
    text = CONDITIONS + HEAD + "".join(f"    {line}\n" for line in (SHARE + body).splitlines())
    found = lint_files({**BASE, "launch/a.launch.py": text}, ["LCH003"]).findings
    return [each.severity.value for each in found]


def at(path: str) -> str:
    return f"os.path.join(share, '{path}')"


@pytest.mark.parametrize(
    ("command", "expected"),
    [
        (f"'map_saver_cli', '-f', {at('maps/new.yaml')}", []),
        (f"'xacro', 'a.xacro', '-o', {at('urdf/a.urdf')}", []),
        (f"'gz', 'sim', '--record-path', {at('a.sdf')}", []),
        (f"'mkdir', '-p', {at('a.d')}", []),
        (f"'bash', '-c', 'echo 1 > ' + {at('a.txt')}", []),
        (f"'xacro', 'a.xacro', '-i', {at('urdf/a.urdf')}", ["warning"]),
        (f"'gz', 'sim', '--output-config', {at('a.sdf')}", ["warning"]),
        (f"'gz', 'sim', {at('a.sdf')}", ["warning"]),
    ],
)
def test_the_output_of_a_command(command: str, expected: list[str]) -> None:
    assert levels(f"return LaunchDescription([ExecuteProcess(cmd=[{command}])])") == expected


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("subprocess.run(['xacro', 'a.xacro', '-o', urdf])", []),
        ("os.system(f'xacro a.xacro > {urdf}')", []),
        ("os.system(f'cat {urdf}')", ["warning"]),
        ("pass", ["warning"]),
    ],
)
def test_a_robot_that_the_launch_file_makes_first(line: str, expected: list[str]) -> None:
    node = "Node(package='robot_state_publisher', executable='robot_state_publisher', arguments=[urdf])"
    assert levels(f"urdf = {at('urdf/a.urdf')}\n{line}\nreturn LaunchDescription([{node}])") == expected


@pytest.mark.parametrize(
    ("program", "name", "path", "expected"),
    [
        ("octomap_saver_node", "octomap_path", "maps/a.bt", ["info"]),
        ("talker", "log_file", "a.txt", ["info"]),
        ("talker", "log_config_file", "a.txt", ["warning"]),
        ("talker", "map_path", "a.txt", ["warning"]),
        ("rtabmap", "database_path", "maps/a.db", []),
    ],
)
def test_what_a_node_writes(program: str, name: str, path: str, expected: list[str]) -> None:
    node = f"Node(package='other_pkg', executable='{program}', parameters=[{{'{name}': {at(path)}}}])"
    assert levels(f"return LaunchDescription([{node}])") == expected


VIEW = f"""\
config = LaunchConfiguration('rviz')
return LaunchDescription([
    DeclareLaunchArgument('rviz', default_value={at("rviz/a.rviz")}),
    DeclareLaunchArgument('view', default_value='{{}}'),
    Node(
        package='rviz2', executable='rviz2', arguments=['-d', config],
        condition=IfCondition(LaunchConfiguration('view')),
    ),
    {{}}
])
"""
INCLUDE = "IncludeLaunchDescription(PythonLaunchDescriptionSource({}))"


@pytest.mark.parametrize(
    ("view", "more", "expected"),
    [
        ("false", "", ["info"]),
        ("true", "", ["warning"]),
        ("false", "LogInfo(msg=config)", ["warning"]),
        ("false", "LogInfo(msg=LaunchConfiguration('rviz'))", ["warning"]),
        ("false", INCLUDE.format("os.path.join(get_package_share_directory('a'), 'launch', 'b.launch.py')"), ["info"]),
    ],
)
def test_the_default_of_what_is_off(view: str, more: str, expected: list[str]) -> None:
    assert levels(VIEW.format(view, more)) == expected


@pytest.mark.parametrize(("name", "expected"), [("TODO", "info"), ("<your_node>", "info"), ("taker", "error")])
def test_a_program_whose_name_is_still_to_be_filled_in(name: str, expected: str) -> None:
    text = f"{HEAD}    return LaunchDescription([Node(package='my_pkg', executable='{name}')])\n"
    found = lint_files({**BASE, "launch/a.launch.py": text}, ["LCH002"]).findings
    assert [each.severity.value for each in found] == [expected]
