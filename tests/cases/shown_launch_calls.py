"""What launch takes in Python: each argument of each kind, said or let be."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest

HEAD = """\
import os
from launch import LaunchDescription
from launch.actions import (
    DeclareLaunchArgument, ExecuteProcess, GroupAction, IncludeLaunchDescription, LogInfo, OpaqueFunction,
    SetEnvironmentVariable, TimerAction)
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import Command, FindExecutable, LaunchConfiguration, PathSubstitution, PythonExpression
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode, ParameterFile, ParameterValue
from launch_ros.substitutions import ExecutableInPackage, FindPackageShare
from ament_index_python.packages import get_package_share_directory
from pathlib import Path
a, b = LaunchConfiguration('a'), LaunchConfiguration('b')
source = get_package_share_directory('my_pkg') + '/launch/other.launch.py'
unknown = os.environ['UNKNOWN']
"""
NEEDED = manifest("  <exec_depend>ros2launch</exec_depend>\n  <exec_depend>p</exec_depend>\n")


def python(*actions: str, before: str = "", returned: str = "") -> Example:
    """A Python launch file that returns some actions, one a line."""
    body = returned or "LaunchDescription([\n" + "".join(f"        {each},\n" for each in actions) + "    ])"
    text = f"{HEAD}{before}\n\ndef generate_launch_description():\n    return {body}\n"
    return Example(bad={"package.xml": NEEDED, "launch/a.launch.py": text}, good={})


def node(*arguments: str) -> tuple[str, ...]:
    return tuple(f"Node(package='p', executable='e', {each})" for each in arguments)


TEXTS = python(
    "LogInfo(msg=5)",
    "LogInfo(msg=['x', 5, unknown, a, 'y'])",
    "LogInfo(msg=None)",
    "LogInfo(msg=True)",
    "LogInfo(msg=IfCondition(a))",
    "LogInfo(msg=LogInfo(msg='x'))",
    "LogInfo(msg=Path('x'))",
    "LogInfo(msg=Path(source) / 'y')",
    "LogInfo(msg=PathSubstitution(FindPackageShare('my_pkg')) / 'y')",
    "LogInfo(msg=unknown)",
    "LogInfo(msg=('x', a))",
    "SetEnvironmentVariable('X', 1)",
)
WORDS = python(
    *node(
        "arguments='--x'",
        "arguments=['x', 1, None, a, [a, 'b'], unknown]",
        "arguments=[1.5]",
        "arguments=5",
        "arguments=a",
        "arguments=None",
        "arguments=unknown",
        "arguments=[Path('x')]",
        "arguments=['a', [5]]",
        "arguments=('x', 'y')",
        "ros_arguments='--log-level'",
        "arguments=[IfCondition(a)]",
    ),
    "ExecuteProcess(cmd='ls -l')",
    "ExecuteProcess(cmd=['ls', 5])",
    "ExecuteProcess(cmd=a)",
)
CONDITIONS = python(
    *(
        f"LogInfo(msg='x', condition={each})"
        for each in (
            "a",
            "'true'",
            "True",
            "None",
            "['x']",
            "{'x': 'y'}",
            "IfCondition(a)",
            "unknown",
            "UnlessCondition(b)",
            "f'{unknown}'",
            "IfCondition('true')",
            "not a",
            "a and b",
            "IfCondition(a) and UnlessCondition(b)",
            "IfCondition(a and b)",
            "IfCondition(a == 'x')",
            "UnlessCondition(True)",
            "IfCondition(unknown)",
        )
    ),
    "LogInfo(msg='x', conditions=IfCondition(a))",
)
ACTIONS = python(
    "TimerAction(period=5, actions=[])",
    "TimerAction(period=5.0, actions=LogInfo(msg='x'))",
    "TimerAction(period='5', actions=[unknown])",
    "TimerAction(period=True, actions=a)",
    "TimerAction(period=a, actions=['x', 5, a])",
    "TimerAction(period=2 + 3, actions=())",
    "GroupAction('x')",
    "GroupAction(5)",
    "GroupAction([[LogInfo(msg='x')], {LogInfo(msg='x')}, {'x': 1}])",
    "GroupAction([ComposableNode(package='p', plugin='p::P', name='n')])",
    "GroupAction(unknown)",
    "GroupAction(actions=None)",
    "[LogInfo(msg='x')]",
    "(LogInfo(msg='x'), LogInfo(msg='y'))",
    "{'x': 'y'}",
    "'x'",
    "f'x{unknown}'",
    "None",
    "a",
    "FindPackageShare('my_pkg')",
    "unknown",
    "ComposableNode(package='p', plugin='p::P', name='n')",
)
PAIRS = python(
    "IncludeLaunchDescription(source, launch_arguments={'a': 'x'})",
    "IncludeLaunchDescription(source, launch_arguments=dict(a='x'))",
    "IncludeLaunchDescription(source, launch_arguments={})",
    "IncludeLaunchDescription(source, launch_arguments={'a': True, 'b': a, 'c': 5, 'd': 'x'}.items())",
    "IncludeLaunchDescription(source, launch_arguments=[{'a': 'x'}])",
    "IncludeLaunchDescription(source, launch_arguments=['a', 'x'])",
    "IncludeLaunchDescription(source, launch_arguments=[('a', 'x'), ('b', 1), ('c', None), ('a', 'b', 5), ('d', a)])",
    "IncludeLaunchDescription(source, launch_arguments=unknown)",
    "IncludeLaunchDescription(source, launch_arguments=('a', 5))",
    "IncludeLaunchDescription(source, launch_arguments=None)",
    before="given = {'a': 'x'}\n",
)
GIVEN = python("IncludeLaunchDescription(source, launch_arguments=given)", before="given = {'a': 'x'}\n")
NODES = python(
    *node(
        "output='scren'",
        "output='screen'",
        "output=5",
        "output=a",
        "output=None",
        "output=''",
        "output='both'",
        "output={'stdout': 'screen'}",
        "name=5",
        "namespace=None",
        "respawn=True",
        "respawn_delay=2",
        "respawn_delay=2.0",
        "paramters=[]",
        "conditions=a",
        "cwd='x'",
        "something_else=5",
        "period=5.0",
        "node_name='x'",
        "node_name='x', name='y'",
        "prefix=[5]",
        "env={'a': 'b'}",
        "additional_env={'a': 5}",
    ),
    "Node(package='p')",
    "Node('p', 'e')",
    "Node('e', package='p')",
    "Node(package='p', node_executable='e')",
    "Node(package='p', executabel='e')",
    "Node(package='p', executable=['e', 5])",
    "Node(package='p', executable='e', **unknown)",
    "Node(**unknown)",
    "DeclareLaunchArgument()",
    "DeclareLaunchArgument('a', default_value=True)",
    "DeclareLaunchArgument('a', default_value=1)",
    "DeclareLaunchArgument('a', default_value=None)",
    "DeclareLaunchArgument('a', default='x')",
    "DeclareLaunchArgument('a', 'x')",
    "DeclareLaunchArgument('a', default_value='x', choices=['x', 'y'], description='which')",
    "DeclareLaunchArgument('a', choices='x')",
    "DeclareLaunchArgument(5)",
    "LogInfo('x')",
    "LogInfo()",
    "ComposableNode(package='p', plugin='p::P')",
    "ComposableNodeContainer(package='p', executable='e', namespace='', composable_node_descriptions=[])",
    "ComposableNodeContainer(package='p', executable='e', name='c', namespace='', composable_node_descriptions=[a])",
)
PARAMETERS = python(
    *node(
        "parameters={'rate': 1}",
        "parameters='a.yaml'",
        "parameters=source",
        "parameters=a",
        "parameters=None",
        "parameters=5",
        "parameters=unknown",
        "parameters=['a.yaml', source, a, unknown, {'rate': 1}]",
        "parameters=[{'rate', 1}]",
        "parameters=[{'name': 'rate', 'value': 1}, {'name': 'a', 'rate': 1}, {'name': a, 'value': 1}]",
        "parameters=[{'rate', a}, 5, None, True]",
        "parameters=[[{'rate': 1}]]",
        "parameters=[['a', 'b']]",
        "parameters=[({'rate': 1},)]",
        "parameters=[{'rate': None}]",
        "parameters=[{'rates': []}]",
        "parameters=[{'rates': {1, 2}}]",
        "parameters=[{'rates': ()}]",
        "parameters=[{'deep': {'rate': None, 'rates': []}}]",
        "parameters=[{a: None}]",
        "parameters=[{'rate': [1, 2], 'x': a, 'y': unknown, 'z': ParameterValue(a, value_type=str)}]",
        "parameters=[ParameterFile('x')]",
        "parameters=({'rate': 1},)",
        "parameters=[]",
        "parameters=[{}]",
    ),
)
REMAPPINGS = python(
    *node(
        "remappings={'a': 'b'}",
        "remappings={}",
        "remappings=[('a', 'b')]",
        "remappings=[('a', 'b', 'c')]",
        "remappings=('a', 'b')",
        "remappings=[['a', 'b']]",
        "remappings=[('a',)]",
        "remappings=[{'a': 'b'}]",
        "remappings=[5]",
        "remappings=['a', ('b', 'c')]",
        "remappings=(('a', 'b'),)",
        "remappings=unknown",
        "remappings=[unknown, ('a', a)]",
        "remappings=[(*unknown, 'a', 'b')]",
        "remappings=None",
        "remappings=[{'a', 'b'}]",
    ),
)
FUNCTIONS = python(
    "OpaqueFunction(function=lambda: [])",
    "OpaqueFunction(function=lambda context: LogInfo(msg='x'))",
    "OpaqueFunction(function=lambda context: [LogInfo(msg='x')])",
    "OpaqueFunction(function=lambda *given: [LogInfo(msg='x')])",
    "OpaqueFunction(function=lambda context: ['x', a])",
    "OpaqueFunction(function=lambda context: LaunchDescription())",
    "OpaqueFunction(function=lambda context: None)",
    "OpaqueFunction(function=[])",
    "OpaqueFunction(function=None)",
    "OpaqueFunction(function=takes_nothing)",
    "OpaqueFunction(function=takes_nothing())",
    "OpaqueFunction(function=takes_it, args=[a])",
    "OpaqueFunction(function=unknown)",
    before="def takes_nothing():\n    return [LogInfo(msg='x')]\n\n\ndef takes_it(context, /):\n    return [5]\n",
)
SUBSTITUTIONS = python(
    "LogInfo(msg=f'from {a}')",
    "LogInfo(msg='from ' + a)",
    "LogInfo(msg=a + 'x')",
    "LogInfo(msg='%s' % a)",
    "LogInfo(msg='{}'.format(a))",
    "LogInfo(msg=str(a))",
    "LogInfo(msg=os.path.join('maps', a))",
    "LogInfo(msg=os.path.exists(a))",
    "LogInfo(msg=Path(a))",
    "LogInfo(msg=a.lower())",
    "LogInfo(msg=a.name)",
    "LogInfo(msg=a[0])",
    "LogInfo(msg={'x': 'y'}.get(a, 'z'))",
    "LogInfo(msg={'x': 'y'}[a])",
    "LogInfo(msg='x' if a == 'b' else 'y')",
    "LogInfo(msg='x' if a else 'y')",
    "LogInfo(msg='x' if a in ['x'] else 'y')",
    "LogInfo(msg='x' if not a else 'y')",
    "LogInfo(msg='x' if IfCondition(a) else 'y')",
    "LogInfo(msg='x' if a is None else 'y')",
    "LogInfo(msg='x' if unknown else a)",
    "LogInfo(msg=float(a))",
    "LogInfo(msg=int(a))",
    "LogInfo(msg=len(a))",
    "LogInfo(msg=open(a))",
    "LogInfo(msg=a / 'x')",
    "LogInfo(msg=FindPackageShare('my_pkg') / 'x')",
    "LogInfo(msg=' '.join([a, 'x']))",
    "LogInfo(msg=[a, 'x'])",
)
NEVER = """\

def never():
    timer = TimerAction(period=5, actions=LogInfo(msg='x'))
    wrong = LogInfo(msg=5, condition='true')
    return LaunchDescription([timer])
"""
IDLE = python("LogInfo(msg='x')", before=NEVER)
CALLED = python("*never().entities", before=NEVER)
CASES = {
    "LCH014": (
        TEXTS, WORDS, CONDITIONS, ACTIONS, PAIRS, GIVEN, NODES, PARAMETERS, REMAPPINGS, FUNCTIONS, SUBSTITUTIONS, IDLE,
        CALLED,
        *(python(returned=each) for each in ("None", "[LogInfo(msg='x')]", "LogInfo(msg='x')", "unknown",
                                             "LaunchDescription(LogInfo(msg='x'))", "LaunchDescription()")),
    ),
}  # fmt: skip
