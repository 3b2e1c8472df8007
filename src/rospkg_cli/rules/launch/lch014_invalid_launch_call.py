"""LCH014 invalid-launch-call."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.call_errors import LaunchCalls
from ...edits.fault_hits import hits
from ...example import Example, manifest
from ...finding import Hit, Safety, Severity
from ...rule import rule

NEEDED = "  <exec_depend>ros2launch</exec_depend>\n  <exec_depend>tf2_ros</exec_depend>\n"
BAD = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='tf2_ros', executable='static_transform_publisher', arguments=['--x', «1.5»]),
    ])
"""
BAD_CONDITION = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.conditions import IfCondition, UnlessCondition
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    quiet = LaunchConfiguration('quiet')
    return LaunchDescription([
        DeclareLaunchArgument('quiet', default_value='false'),
        LogInfo(msg='up', condition=IfCondition(«not quiet»)),
    ])
"""


@rule(
    "LCH014",
    "invalid-launch-call",
    over=LaunchCalls,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "the launch goes on, with another value than intended",
        Severity.INFO: "it is another value than intended, which nothing uses, or which is only printed, the action "
        "is never added, or not by default, or has a condition that says what a test before it says, or "
        "the repository is for Foxy alone, which takes it",
    },
    examples=(
        Example(
            bad={"package.xml": manifest(NEEDED), "launch/a.launch.py": BAD},
            good={"launch/a.launch.py": BAD.replace("«1.5»", "'1.5'")},
            fix=Safety.SAFE,
        ),
        Example(
            bad={"package.xml": manifest(NEEDED), "launch/a.launch.py": BAD_CONDITION},
            good={"launch/a.launch.py": BAD_CONDITION.replace("IfCondition(«not quiet»)", "UnlessCondition(quiet)")},
        ),
    ),
)
def invalid_launch_call(calls: LaunchCalls) -> Iterator[Hit]:
    """
    ## What it does
    Finds calls in Python launch files that raise, or do not do what they say.
    They are

    - numbers where launch takes strings, a value where a parameter file is expected, a set where a dict of parameters
      or a list of words is expected, a parameter as a pair (`{'name': 'rate', 'value': 1}`), an action or
      `MoveItConfigs` as a parameter;
    - `launch_arguments` without `.items()`, a method or function that is not called (`args.items`);
    - a path that is joined from a tuple or a list, one text where a list of parts is expected;
    - a comma that makes a tuple of an action, words that lack a comma between them (`['-topic' 'robot']`);
    - a launch description source for files of another kind (`XMLLaunchDescriptionSource` of a `.launch.py`);
    - arguments that a class does not have, or that are missing;
    - code that treats a substitution as if its value were known while the file is read: `not x`, `if x:`, `x ==
      'true'`, `os.path.join(x, …)`, `f'{x}'`, `names.get(x)`.

    ## Why is this bad?
    Most of these end the launch with a TypeError from deep inside of launch. With the others it goes on: a condition is
    always true, a path holds the name of a Python object.

    ## When it is quiet
    Left alone are

    - arguments of unknown value, and files that `ros2 launch` can't start;
    - comparisons of a helper that takes plain values as well, and performs substitutions (`x == True or
      x.perform(context) == 'true'`);
    - a number or word behind an option of one letter (`'-z' '1.5'`), which most programs take in one word;
    - dicts for `include_scoped_launch_py_description` of launch_pal, which takes one.

    It is an info

    - in a function that nothing calls;
    - for a LifecycleNode without a namespace where pages and scripts name Foxy alone, which gives it one;
    - for what launch looks at only when it visits an action, and for a call that goes on with another value, where
      nothing adds the action or reads the value or argument (of an `if`, all that it chooses among), or the action is
      off by default;
    - for a pathlib.Path where a text is expected: launch of all supported distributions takes it since January 2026.

    ## Fix safety
    A number is quoted, `.items()` is added: what launch requires.
    """
    yield from hits(calls.file.path, calls.faults())
