"""What Python launch files hand to launch, and which names they use."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.launch.call_errors import call_faults
from rospkg_cli.checks.launch.robot_parameters import robot_parameters
from rospkg_cli.checks.launch.wrong_imports import wrong_imports
from rospkg_cli.example import manifest
from rospkg_cli.files import PackageFiles
from rospkg_cli.languages.python.undefined_names import undefined_names
from rospkg_cli.package.launch.launch_file import LaunchFile
from rospkg_cli.package.package import Package
from rospkg_cli.rule import all_rules
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import MemoryTree

HEAD = """\
import os
from launch import LaunchDescription
from launch.actions import (
    DeclareLaunchArgument, GroupAction, IncludeLaunchDescription, LogInfo, OpaqueFunction, SetEnvironmentVariable,
    TimerAction)
from launch.conditions import IfCondition, UnlessCondition
from launch.event_handlers import OnProcessExit
from launch.substitutions import PathSubstitution, Command, FindExecutable, LaunchConfiguration
from launch_ros.actions import ComposableNodeContainer, LifecycleNode, LoadComposableNodes, Node
from launch_ros.descriptions import ComposableNode
from launch_ros.substitutions import FindPackageShare
from ament_index_python.packages import get_package_share_directory
from pathlib import Path
a, b = LaunchConfiguration('a'), LaunchConfiguration('b')
c = LaunchConfiguration('c')
source = get_package_share_directory('nav2_bringup') + '/launch/other.launch.py'
"""


def read(text: str) -> LaunchFile:
    found = Package(PackageFiles(MemoryTree.of({"launch/a.launch.py": text}), "")).parts(LaunchFile).only
    assert found is not None
    return found


def misused(*actions: str) -> list[str]:
    """Return the code of what is misused when these are built."""
    file = read(f"{HEAD}def generate_launch_description():\n    return LaunchDescription([{', '.join(actions)}])\n")
    return [file.source.slice(each.span) for each in call_faults(file)]


@pytest.mark.parametrize(
    "action, place",
    [
        ("LogInfo(msg='x', condition=IfCondition(not a))", "not a"),
        ("LogInfo(msg='x', condition=IfCondition(a and b))", "a and b"),
        (
            "LogInfo(msg='x', condition=(IfCondition(a) and UnlessCondition(b)))",
            "IfCondition(a) and UnlessCondition(b)",
        ),
        ("LogInfo(msg='x', condition=UnlessCondition(a == 'b'))", "a == 'b'"),
        ("LogInfo(msg='x', condition=IfCondition(True))", "True"),
        ("LogInfo(msg='x', condition=a)", "condition=a"),
        ("LogInfo(msg='x', condition='true')", "'true'"),
        ("LogInfo(msg=f'from {a}')", "f'from {a}'"),
        ("LogInfo(msg='from ' + a)", "'from ' + a"),
        ("LogInfo(msg=os.path.join('maps', a))", "os.path.join('maps', a)"),
        ("LogInfo(msg=a.lower())", "a.lower()"),
        ("LogInfo(msg=['a', 5])", "5"),
        ("LogInfo('x')", "'x'"),
        ("Node(package='p', executable='e', arguments=['--x', 1.5])", "1.5"),
        ("Node(package='p', executable='e', arguments='--x 1')", "'--x 1'"),
        ("Node(package='p', executable='e', arguments=['-d', Path(get_package_share_directory('p')) / 'a.rviz'])",
         "Path(get_package_share_directory('p')) / 'a.rviz'"),
        ("Node(package='p', executable='e', parameters=[{'rate', a}])", "{'rate', a}"),
        ("Node(package='p', executable='e', parameters={'rate': 1})", "{'rate': 1}"),
        ("Node(package='p', executable='e', parameters=[[{'rate': 1}]])", "[{'rate': 1}]"),
        ("Node(package='p', executable='e', parameters=[{'rate': None}])", "None"),
        ("Node(package='p', executable='e', parameters=[{'rates': []}])", "[]"),
        ("Node(package='p', executable='e', remappings={'a': 'b'})", "{'a': 'b'}"),
        ("Node(package='p', executable='e', remappings=[('a', 'b', 'c')])", "('a', 'b', 'c')"),
        ("Node(package='p', executable='e', remappings=('a', 'b'))", "('a', 'b')"),
        ("Node(package='p', executable='e', output='scren')", "'scren'"),
        ("Node(package='p', executable='e', paramters=[])", "paramters=[]"),
        ("Node(package='p')", "Node(package='p')"),
        ("Node('p', 'e')", "'p'"),
        ("ComposableNodeContainer(package='p', executable='e', namespace='', composable_node_descriptions=[])",
         "ComposableNodeContainer(package='p', executable='e', namespace='', composable_node_descriptions=[])"),
        ("ComposableNode(package='p', plugin='p::P')", "ComposableNode(package='p', plugin='p::P')"),
        ("DeclareLaunchArgument('a', default_value=True)", "True"),
        ("DeclareLaunchArgument('a', default='x')", "default='x'"),
        ("DeclareLaunchArgument('a', 'x')", "'x'"),
        ("IncludeLaunchDescription(source, launch_arguments={'a': 'x'})", "{'a': 'x'}"),
        ("IncludeLaunchDescription(source, launch_arguments={'a': True}.items())", "True"),
        ("IncludeLaunchDescription(source, launch_arguments=[{'a': 'x'}])", "{'a': 'x'}"),
        ("TimerAction(period=5, actions=[])", "5"),
        ("TimerAction(period=5.0, actions=LogInfo(msg='x'))", "LogInfo(msg='x')"),
        ("GroupAction([[LogInfo(msg='x')]])", "[LogInfo(msg='x')]"),
        ("None", "None"),
        ("'x'", "'x'"),
        ("a", "a"),
        ("SetEnvironmentVariable('x', 1)", "1"),
        ("OpaqueFunction(function=lambda: [])", "OpaqueFunction(function=lambda: [])"),
        ("OpaqueFunction(function=lambda context: LogInfo(msg='x'))", "LogInfo(msg='x')"),
        ("OpaqueFunction(function=[])", "[]"),
    ],
)  # fmt: skip
def test_launch_can_not_take_it(action: str, place: str) -> None:
    assert misused(action) == [place]


@pytest.mark.parametrize(
    "action, level",
    [
        ("LogInfo(msg='x', condition=IfCondition(not a))", None),
        ("LogInfo(msg='x', condition=IfCondition(a and b))", "warning"),
        ("LogInfo(msg='x', condition=a or b)", None),
        ("LogInfo(msg='x', condition=IfCondition(IfCondition(a) or a))", None),
        ("LogInfo(msg='x', condition=IfCondition(a) and a)", None),
        ("LogInfo(msg='x', condition=IfCondition(a) or a)", "warning"),
        ("LogInfo(msg='x', condition=IfCondition(a and IfCondition(b)))", None),
        ("LogInfo(msg='x', condition=UnlessCondition(a == 'b'))", None),
        ("LogInfo(msg='x' if a == 'b' else 'y')", "warning"),
        ("LogInfo(msg='x' if c else 'y')", "warning"),
        ("LogInfo(msg='x' if IfCondition(a) else 'y')", "warning"),
        ("LogInfo(msg='x' if True and LaunchConfiguration('c') else 'y')", "warning"),
        ("LogInfo(msg=f'from {a}')", "warning"),
        ("LogInfo(msg={'x': 'y'}.get(a, 'z'))", "warning"),
        ("LogInfo(msg='from ' + a)", None),
        ("LogInfo(msg=os.path.join('maps', a))", None),
        ("LogInfo(msg=a.lower())", None),
    ],
)
def test_a_launch_that_goes_on_is_a_warning(action: str, level: str | None) -> None:
    file = read(f"{HEAD}def generate_launch_description():\n    return LaunchDescription([{action}])\n")
    assert [each.level for each in call_faults(file)] == [level]


@pytest.mark.parametrize(
    "test",
    [
        "if c: pass",
        "if y and c: pass",
        "if IfCondition(a): pass",
        "while IfCondition(a) and x: pass",
        "x if a == 'b' else y",
    ],
)
def test_a_test_that_python_makes_is_a_warning(test: str) -> None:
    file = read(f"{HEAD}x = y = 1\ndef generate_launch_description():\n    {test}\n    return LaunchDescription([])\n")
    assert [each.level for each in call_faults(file)] == ["warning"]


@pytest.mark.parametrize(
    "action, level",
    [
        ("LogInfo(msg='x', condition=a)", "info"),
        ("Node(package='p', executable='e', output='scren')", "info"),
        ("TimerAction(period=5.0, actions=LogInfo(msg='x'))", "info"),
        ("IncludeLaunchDescription(source, launch_arguments={'a': 'x'})", "info"),
        ("Node(package='p', executable='e', arguments=['--x', 1.5])", None),
    ],
)
def test_what_launch_looks_at_later_is_an_info_where_nothing_adds_it(action: str, level: str | None) -> None:
    text = f"{HEAD}def generate_launch_description():\n    action = {action}\n    return LaunchDescription([ADDED])\n"
    (fault,) = call_faults(read(text.replace("ADDED", "")))
    assert fault.level == level
    assert fault.message.endswith(", as soon as the action is added") is (level == "info")
    (added,) = call_faults(read(text.replace("ADDED", "action")))
    assert added.level is None


@pytest.mark.parametrize(
    "action",
    [
        "LogInfo(msg='x', condition=IfCondition(a))",
        "LogInfo(msg={'x': 'y'}.get('x', a))",
        "LogInfo(msg='x' if isinstance(a, str) else 'y')",
        "LogInfo(msg=['from ', a])",
        "LogInfo(msg='x', condition=None)",
        "Node(package='p', executable='e', arguments=['--x', '1.5', a], parameters=[{'rate': 1.5}, 'a.yaml', a])",
        "Node(package='p', executable='e', name=None, namespace=[a, '/x'], output={'both': 'screen'})",
        "Node(executable='e', remappings=[('a', 'b'), (a, [b, '/x'])], output=a)",
        "Node(package='p', executable='e', parameters=[{'nested': {'rate': 1}, ('a', b): a, 'names': ['x', 'y']}])",
        "Node(package='p', executable='e', arguments=['-d', str(Path(get_package_share_directory('p')) / 'a.rviz')])",
        "Node(package='p', executable='e', node_name='x')",
        "IncludeLaunchDescription(source, launch_arguments={'a': 'x', 'b': b}.items())",
        "IncludeLaunchDescription(source, launch_arguments=[('a', 'x')])",
        "*[LogInfo(msg='x')]",
        "LaunchDescription([])",
        "GroupAction([LogInfo(msg='x')], scoped=False)",
        "OpaqueFunction(function=lambda context: [LogInfo(msg='x')])",
        "OpaqueFunction(function=lambda context, *args: None, args=[a])",
        "LogInfo(msg=FindPackageShare('p').find('p'))",
        "LogInfo(msg=PathSubstitution(FindPackageShare('p')) / 'b')",
        "LogInfo(msg='x', condition=IfCondition(a if isinstance(a, LaunchConfiguration) else a == 'b'))",
        "TimerAction(period=5.0, actions=[], condition=IfCondition('true'))",
        "ComposableNodeContainer(package='p', executable='e', name='c', namespace=None)",
    ],
)
def test_launch_takes_it(action: str) -> None:
    assert misused(action) == []


@pytest.mark.parametrize(
    "action, codes",
    [
        ("Node(package='p', type='e.py')", ["LCH005 write `executable`"]),
        (
            "LifecycleNode(pkg='p', type='e', name='n', namespace='')",
            ["LCH005 write `package`", "LCH005 write `executable`"],
        ),
        ("Node(package='p', executable='e', type='x')", ["LCH005 remove it"]),
        ("ComposableNode(package='p', plugin='x', type='y')", ["LCH014 a component needs a container"]),
    ],
)
def test_keywords_of_ros1_are_renamed(action: str, codes: list[str]) -> None:
    text = f"{HEAD}def generate_launch_description():\n    return LaunchDescription([{action}])\n"
    found = lint_files({"package.xml": manifest(), "launch/a.launch.py": text}, ["LCH005", "LCH014"]).findings
    assert [f"{each.code} {each.message.split('; ')[-1].split(': ')[-1]}" for each in found] == codes


@pytest.mark.parametrize(
    ("path", "other", "count"),
    [
        ("launch/start_eloquent.py", "launch/start.py", 0),
        ("launch/elequent_start.py", "launch/start.py", 0),
        ("launch/foxy/a.launch.py", "launch/humble/a.launch.py", 0),
        ("launch/a_foxy.launch.py", "launch/a_dashing.launch.py", 1),
        ("launch/a_foxy_humble.launch.py", "launch/a.launch.py", 1),
        ("launch/a_galactic.launch.py", "launch/a.launch.py", 1),
        ("launch/a.launch.py", "launch/b.launch.py", 1),
    ],
)
def test_launch_files_that_are_kept_for_older_distributions(path: str, other: str, count: int) -> None:
    start = f"{HEAD}def generate_launch_description():\n    return LaunchDescription([Node(package='p', "
    old, new = (f"{start}{key}='e')])\n" for key in ("node_executable", "executable"))
    found = lint_files({"package.xml": manifest(), path: old, other: new}, ["LCH005"]).findings
    assert len(found) == count


def test_a_description_that_is_not_returned() -> None:
    file = read("from launch import LaunchDescription\ndef generate_launch_description():\n    LaunchDescription([])\n")
    assert [file.source.slice(each.span) for each in call_faults(file)] == ["generate_launch_description"]


@pytest.mark.parametrize(
    "text, names",
    [
        ("def f():\n    return [Node()]\n", ["Node"]),
        ("from x import *\ndef f():\n    return [Node()]\n", []),
        ("def f(a):\n    return [b for b in a] + [b]\n", ["b"]),
        ("def f():\n    global x\n    x = 1\ndef g():\n    return x\n", []),
        ("class A:\n    rate = 1\n    def f(self):\n        return rate\n", ["rate"]),
        ("try:\n    unicode\nexcept NameError:\n    unicode = str\nprint(unicode)\n", []),
        ("try:\n    pass\nexcept OSError as error:\n    print(error)\n", []),
        ("def f(a: Missing) -> Missing:\n    return __file__\n", []),
        ("def f(x):\n    match x:\n        case {'a': a, **rest}:\n            return a, rest\n        case [*b]:\n"
         "            return b\n", []),
        ("if (n := 1):\n    print(n)\nf = lambda x, *y: (x, y, z)\n", ["z"]),
        ("globals()['x'] = 1\nprint(x)\n", []),
        ("with open('a') as f, open('b') as (g, h):\n    print(f, g, h, i)\n", ["i"]),
        ("import a.b as c, d.e\nprint(c, d, a)\n", ["a"]),
    ],
)  # fmt: skip
def test_names_that_nothing_defines(text: str, names: list[str]) -> None:
    file = read(f"{text}\ndef generate_launch_description(): ...\n").python
    assert file is not None
    assert [each.name for each in undefined_names(file)] == names


def test_imports_from_the_wrong_module() -> None:
    file = read(
        "from launch.actions import Node, LogInfo, DeclareLaunchArguments, Brandnew\n"
        "from launch_ros.actions import ComposableNode\n"
        "from launch import actions, LaunchDescription, LaunchConfiguration\n"
        "from launch_ros.parameter_descriptions import SomeSubstitutionsType\n"
        "def generate_launch_description(): ...\n"
    ).python
    assert file is not None
    assert [(each.name, each.home or each.near) for each in wrong_imports(file)] == [
        ("Node", "launch_ros.actions"),
        ("DeclareLaunchArguments", "DeclareLaunchArgument"),
        ("ComposableNode", "launch_ros.descriptions"),
        ("LaunchConfiguration", "launch.substitutions"),
    ]


@pytest.mark.parametrize(
    ("module", "name", "meant"),
    [
        ("substitutions", "StringJoinSubstitution", ""),
        ("substitutions", "BooleanSubstitution", ""),
        ("substitutions", "LongPathJoinSubstitution", ""),
        ("substitutions", "PathJoinSubstitutions", "PathJoinSubstitution"),
        ("substitutions", "PathJionSubstituton", "PathJoinSubstitution"),
        ("actions", "ForEach", ""),
        ("actions", "LogWarning", ""),
    ],
)
def test_what_a_newer_launch_exports_is_no_slip(module: str, name: str, meant: str) -> None:
    file = read(f"from launch.{module} import {name}\ndef generate_launch_description(): ...\n").python
    assert file is not None
    assert [each.near for each in wrong_imports(file)] == ([meant] if meant else [])


@pytest.mark.parametrize(
    "value, spans",
    [
        ("Command(['xacro ', a])", ["Command(['xacro ', a])"]),
        ("Command([FindExecutable(name='xacro'), ' ', a])", ["Command([FindExecutable(name='xacro'), ' ', a])"]),
        ("[Command(['cat ', 'robot.urdf'])]", ["[Command(['cat ', 'robot.urdf'])]"]),
        ("Command(['uname'])", []),
        ("ParameterValue(Command(['xacro ', a]), value_type=str)", []),
    ],
)
def test_robot_descriptions_that_are_read_as_yaml(value: str, spans: list[str]) -> None:
    text = (
        f"{HEAD}from launch_ros.descriptions import ParameterValue\n"
        "def generate_launch_description():\n    return LaunchDescription([\n"
        f"        Node(package='p', executable='e', parameters=[{{'robot_description': {value}}}])])\n"
    )
    file = read(text)
    evaluated = file.evaluated
    assert evaluated is not None
    assert [file.source.slice(each.span) for each in robot_parameters(evaluated)] == spans


@pytest.mark.parametrize(
    "comment, level",
    [("base: on the floor", "warning"), ("the base", "info"), ("see #3", "warning"), ("a:b", "info")],
)
def test_what_yaml_can_not_read_of_a_robot(comment: str, level: str) -> None:
    example = next(rule for rule in all_rules() if rule.code == "LCH009").examples[0]
    robot = '<robot name="r">\n  <xacro:include filename="$(find my_pkg)/urdf/base.xacro"/>\n</robot>\n'
    base = f"<robot>\n  <!-- {comment} -->\n</robot>\n"
    files = {**example.bad_files(), "urdf/robot.urdf.xacro": robot, "urdf/base.xacro": base}
    (finding,) = lint_files(files, ["LCH009"]).findings
    assert finding.severity.value == level


@pytest.mark.parametrize(
    "lines, level",
    [
        ("x = missing", "error"),
        ("if x: y = missing", "warning"),
        ("if x: pass\n    else: y = missing", "warning"),
        ("y = missing if x else 1", "warning"),
        ("y = 1 if missing else 1", "error"),
        ("if missing: pass", "error"),
        ("for each in [1]: y = missing", "error"),
    ],
)
def test_a_name_in_a_branch_stops_only_some(lines: str, level: str) -> None:
    text = f"{HEAD}x = input()\ndef generate_launch_description():\n    {lines}\n    return LaunchDescription([])\n"
    (finding,) = lint_files({"package.xml": manifest(), "launch/a.launch.py": text}, ["LCH013"]).findings
    assert finding.severity.value == level
    assert ("where it gets here" in finding.message) is (level == "warning")
