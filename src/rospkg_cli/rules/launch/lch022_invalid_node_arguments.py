"""LCH022 invalid-node-arguments."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.node_arguments import StartedPrograms
from ...checks.launch.who_meets import level_met
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...rule import rule

NEEDED = "  <exec_depend>ros2launch</exec_depend>\n  <exec_depend>tf2_ros</exec_depend>\n"
BAD = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(
            package='tf2_ros',
            executable='static_transform_publisher',
            arguments=['0', '0', '0.3', '0', '0', '0', '«base_link»', 'laser', '100'],
        ),
    ])
"""
OPTIONS = """\
<launch>
  <node pkg="tf2_ros" exec="static_transform_publisher" args="«--z 0.3 --parent-frame-id base --child-frame-id laser»"/>
</launch>
"""


@rule(
    "LCH022",
    "invalid-node-arguments",
    over=StartedPrograms,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "the node is started only under a condition",
        Severity.INFO: "the node is never added to the launch description, or the program passes over the word",
    },
    examples=(
        Example(
            bad={"package.xml": manifest(NEEDED), "launch/a.launch.py": BAD},
            good={"launch/a.launch.py": BAD.replace("«base_link»", "base_link").replace(", '100'", "")},
        ),
        Example(
            bad={"package.xml": manifest(NEEDED), "launch/a.launch.xml": OPTIONS},
            good={
                "launch/a.launch.xml": OPTIONS.replace("--parent-frame-id", "--frame-id")
                .replace("«", "")
                .replace("»", "")
            },
        ),
    ),
)
def invalid_node_arguments(started: StartedPrograms) -> Iterator[Hit]:
    """
    ## What it does
    Finds arguments that a well-known program refuses when it starts.
    It knows `static_transform_publisher` of tf2_ros (how many words there are, which of them are numbers, the options),
    and the options of controller_manager's `spawner`, gazebo_ros' `spawn_entity.py` and ros_gz_sim's `create`.

    ## Why is this bad?
    The program ends at once, and says so in the midst of all other messages: a frame is missing in the tree, or a
    controller is not started. A period at the end was right in ROS 1: "Failed to parse qw argument as float".

    ## When it is quiet
    Left alone are programs of the workspace, arguments for ROS (behind `--ros-args`), and flags of `create` in a test
    (`launch_testing`). Options of any supported distribution count as known, also shortened where argparse takes that.
    Where the words are not all known, a value of an argument is one word that may be right.
    """
    for fault in started.faults():
        softer, why = level_met(started.file, fault.span, started.workspace)
        message = f"{fault.message}{why and ', '}{why}"
        level = fault.level or softer
        yield Hit(started.file.path, fault.span, message, Severity(level) if level else None)
