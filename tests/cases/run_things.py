"""What never comes to the node, the launch or the robot, and what is for older distributions alone."""

from __future__ import annotations

from rospkg_cli.example import Example

NAV2 = """\
controller_server:
  ros__parameters:
    controller_frequency: 20.0
planner_server:
  ros__parameters:
    expected_planner_frequency: 20.0
bt_navigator:
  ros__parameters:
    global_frame: map
global_costmap:
  global_costmap:
    ros__parameters:
      width: 0.5
local_costmap:
  ros__parameters:
    width: 0.5
"""


def costmaps(text: str = NAV2) -> Example:
    return Example(bad={"config/nav2.yaml": text}, good={}, on="config")


PRINTED = """\
import logging

from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    path = LaunchConfiguration('path')
    print(str(path), 'is the path')
    logging.getLogger().info(f'the path is {path}')
    return LaunchDescription([ExecuteProcess(cmd=['ls', str(path)])])
"""


CASES = {
    "LCH014": (Example(bad={"launch/a.launch.py": PRINTED}, good={}),),
    "PRM003": (
        costmaps(),
        costmaps(NAV2.replace("bt_navigator", "local_costmap/local_costmap")),
        costmaps(NAV2.replace("controller_server", "smoother_server")),
    ),
    "PRM006": (costmaps(),),
}
