"""LCH019 unknown-bridge-type."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.bridge_arguments import bridge_faults
from ...checks.launch.bridge_configs import Bridges
from ...checks.launch.lost_faults import where_met
from ...edits.fault_hits import hits
from ...example import Example, manifest
from ...finding import Hit, Safety, Severity
from ...rule import rule

BAD = """\
<launch>
  <node pkg="ros_gz_bridge" exec="parameter_bridge" args="/clock@«rosgraph_msg»/msg/Clock[gz.msgs.Clock"/>
</launch>
"""
CONFIG = """\
- topic_name: chatter
  ros_type_name: «"std_msgs::msg::String"»
  gz_type_name: gz.msgs.StringMsg
  direction: GZ_TO_ROS
"""
NEEDED = "  <exec_depend>ros2launch</exec_depend>\n  <exec_depend>ros_gz_bridge</exec_depend>\n"


@rule(
    "LCH019",
    "unknown-bridge-type",
    over=Bridges,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "nothing adds the bridge to the launch description, it is off by default, or nothing names the "
        "file"
    },
    examples=(
        Example(
            bad={"package.xml": manifest(NEEDED), "launch/a.launch.xml": BAD},
            good={"launch/a.launch.xml": BAD.replace("«rosgraph_msg»", "rosgraph_msgs")},
        ),
        Example(
            on="config",
            bad={"config/bridge.yaml": CONFIG, "README.md": "The bridge reads `config/bridge.yaml`.\n"},
            good={"config/bridge.yaml": CONFIG.replace('«"std_msgs::msg::String"»', '"std_msgs/msg/String"')},
            fix=Safety.SAFE,
        ),
    ),
)
def unknown_bridge_type(bridges: Bridges) -> Iterator[Hit]:
    """
    ## What it does
    Finds types that ros_gz_bridge can't take, in arguments of `parameter_bridge` and config files.
    An argument is `topic@package/msg/Type`, followed by `@`, `[` or `]` and the type of Gazebo. In a config file a type
    has to be written in the same way; a direction that the bridge does not know is reported too, and `topic_name`
    together with `ros_topic_name` or `gz_topic_name`. Two types in the wrong order, one alone, and two that are not
    made for each other (`sensor_msgs/msg/Imu[gz.msgs.Imu`, which is `gz.msgs.IMU`) are no pair.

    ## Why is this bad?
    The bridge says that it knows no such pair of types, and goes on without the topic.

    ## When it is quiet
    A package that may exist is believed, and so is a type of it that is near none of its known ones. A later bridge may
    know other types of Gazebo, and one of the workspace other pairs. A bridge that nothing adds to the launch
    description, or that is off by default, is an info, and so is a config file that no launch file, code or page names.

    ## Fix safety
    `std_msgs::msg::String` becomes `std_msgs/msg/String`, which names the same.
    """
    for scope in bridges.scopes:
        yield from hits(scope.file.path, where_met(scope, bridge_faults(scope), (None,)))
    for path, fault in bridges.config_faults():
        yield from hits(path, [fault])
