"""Methods, functions and containers that launch files hand on where a text or a result is meant."""

from __future__ import annotations

from .shown_launch_calls import node, python

FUNCTIONS = (
    "\n\ndef words():\n    return ['a']\n\n\n@made\ndef other():\n    return ['a']\n\n\n"
    "NAMES, GIVEN = ['a'], {'a': 'b'}\n"
)
INCLUDE = "IncludeLaunchDescription(source, launch_arguments={})"
UNCALLED = python(
    *(INCLUDE.format(each) for each in ("GIVEN.items", "{'a': 'b'}.items", "GIVEN.items()", "unknown.items", "words")),
    *(INCLUDE.format(each) for each in ("GIVEN.other", "GIVEN", "a.perform")),
    *node("arguments=words", "arguments=words()", "arguments=other", "arguments=[words, 'a'.upper, Path('a').name]"),
    *node("parameters=[GIVEN.copy]", "arguments=[NAMES.copy, a.perform]", "condition=words", "on_exit=words"),
    "OpaqueFunction(function=words)",
    "LogInfo(msg='a'.upper)",
    "LogInfo(msg=words)",
    "LogInfo(msg=lambda: 'a')",
    "TimerAction(period=1.0, actions=[words])",
    "words",
    before=FUNCTIONS,
)
REFUSED = python(
    "LogInfo(msg=os.path.join(PAIR, 'a'))",
    "LogInfo(msg=os.path.join('a', PAIR))",
    "LogInfo(msg=os.path.join(HINTED, 'a'))",
    "LogInfo(msg=os.path.join(PAIR[0], 'a'))",
    "LogInfo(msg=os.path.join(*PAIR, 'a'))",
    "LogInfo(msg=os.path.dirname(['a']))",
    "LogInfo(msg=os.path.exists(unknown))",
    "LogInfo(msg='a' + PAIR)",
    "LogInfo(msg=['a'] + ['b'])",
    "LogInfo(msg=Path('a') / PAIR)",
    "LogInfo(msg='a' % PAIR)",
    "LogInfo(msg={'a': 1} + 'a')",
    before="PAIR = get_package_share_directory('my_pkg'),\nHINTED: str = unknown,\n"
    "if unknown:\n    print('a' + PAIR)\n",
)
SEAMS = python(
    "ExecuteProcess(cmd=['ros2 run p spawner' + f'--controller-manager /{NAME}'], shell=True)",
    "ExecuteProcess(cmd=['ros2 run p spawner ' + f'--inactive /{NAME}'], shell=True)",
    "ExecuteProcess(cmd=['ros2', 'run', 'p', 'e' '--quick'])",
    "ExecuteProcess(cmd=['a.sh', 'x--slow'])",
    "ExecuteProcess(cmd=['a.sh', f'{NAME}--slow', a, NAME + '--' + NAME, unknown + '--first'])",
    "LogInfo(msg='e' '--quick')",
    "LogInfo(msg=Command('xacro a.urdf' + '--inorder'))",
    "LogInfo(msg=Command(['xacro ', a, '--verbose']))",
    "LogInfo(msg=Command(['xacro ', 'a.urdf', '--verbosity 1']))",
    *node("arguments=['--name' '--other', 'x']", "arguments=['--name', '--third']"),
    before="NAME = 'arm'\n",
)
LOST = python(
    *node("arguments=['-topic' 'robot_description', '-entity', 'arm']", "arguments=['-topic', 'robot' '-entity', 'a']"),
    *node("arguments=['--a' '/b/c']", "arguments=['a:=' '/b/c', '--long-' 'option', '/a/' 'b', '-' 'x', 'a' '-1']"),
    *node("arguments=['a b' 'c']", "arguments=[('-x' 'y')]", "arguments=['-a' f'{NAME}']", "name='a' 'b'"),
    *node("ros_arguments=['--log-level' 'debug']", "arguments=['prefix_' 'name', '-x=' 'y', 'a.b' 'c']"),
    "ExecuteProcess(cmd=['ros2', 'bag' 'record', '-a'])",
    "ExecuteProcess(cmd=['ros2 bag record' ' -a'], shell=True)",
    before="NAME = 'arm'\n",
)
CASES = {"LCH014": (UNCALLED, REFUSED, SEAMS, LOST)}
