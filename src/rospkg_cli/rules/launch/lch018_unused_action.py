"""LCH018 unused-action."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.copied_actions import reported_once
from ...checks.launch.launch_configurations import LaunchConfigurations
from ...checks.launch.unused_actions import UnusedAction
from ...example import Example, manifest
from ...finding import Hit, Related, Severity
from ...rule import rule

BAD = """\
from launch import LaunchDescription
from launch.actions import LogInfo


def generate_launch_description():
    first = LogInfo(msg='up')
    «second» = LogInfo(msg='ready')
    return LaunchDescription([first])
"""
TWICE = BAD.replace("first = ", "«ready» = ").replace("«second» = ", "ready = ").replace("[first]", "[ready]")
AWAITED = """\
from launch import LaunchDescription
from launch.actions import ExecuteProcess, LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessExit


def generate_launch_description():
    «first» = ExecuteProcess(cmd=['true'])
    handler = OnProcessExit(target_action=first, on_exit=[LogInfo(msg='done')])
    return LaunchDescription([RegisterEventHandler(handler)])
"""
NEEDED = manifest("  <exec_depend>ros2launch</exec_depend>\n")


@rule(
    "LCH018",
    "unused-action",
    over=LaunchConfigurations,
    severity=Severity.INFO,
    levels={Severity.WARNING: "an event handler waits for it"},
    examples=(
        Example(
            bad={"package.xml": NEEDED, "launch/a.launch.py": BAD},
            good={"launch/a.launch.py": BAD.replace("[first]", "[first, second]").replace("«second»", "second")},
        ),
        Example(
            bad={"package.xml": NEEDED, "launch/a.launch.py": AWAITED},
            good={
                "launch/a.launch.py": AWAITED.replace("[RegisterEvent", "[first, RegisterEvent")
                .replace("«", "")
                .replace("»", "")
            },
        ),
        Example(
            bad={"package.xml": NEEDED, "launch/a.launch.py": TWICE},
            good={"launch/a.launch.py": TWICE.replace("«ready»", "up").replace("[ready]", "[up, ready]")},
        ),
    ),
)
def unused_action(configurations: LaunchConfigurations) -> Iterator[Hit]:
    """
    ## What it does
    Finds nodes, includes and other actions of a Python launch file that are made and never added.
    The action is bound to a name that nothing but an event handler reads, to one that holds something else before it
    is read, or to none at all (`Node(…),` as a statement).

    ## Why is this bad?
    launch visits only what the launch description holds: the node is never started, and nothing says so.

    ## When it is quiet
    It is an info, as many an action is left out on purpose; what copies of a launch file have alike is one finding, at
    the first. It is a warning where an event handler waits for the action (`OnProcessExit(target_action=…)`) and no
    comment mentions it: nothing that the handler holds starts, unless the launch description holds all of that too.

    Left alone are names that a comment mentions or that begin with `_`, as they were taken out on purpose, and
    arguments whose use LCH008 or LCH017 reports.
    """
    for action, places in reported_once(configurations):
        message = f"{action.what} is made and never added to the launch description: {action.harm}"
        if action.again:
            message = f"line {action.again} gives {action.what} to something else before this is added: {action.harm}"
        level = Severity.WARNING if action.is_awaited else None
        others = tuple(Related(path, span, "and here, in a copy") for path, span in places)
        whole = f"{message}; {advice(action, configurations)}"
        yield Hit(configurations.file.path, action.span, whole, level, others)


def advice(action: UnusedAction, configurations: LaunchConfigurations) -> str:
    if action.is_vain:
        return "remove it and the event handler, or let the handler alone start the rest"
    if action.is_gone:
        return "its executable is not here any more; remove it"
    if action.starter:
        own = action.starter == configurations.file.path
        return f"{'another action' if own else f'`{action.starter}`'} starts the same; remove it"
    return "give it a name of its own" if action.again else "add it, or remove it"
