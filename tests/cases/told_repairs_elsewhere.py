"""Faults that people repaired in launch files, parameters and robots, told again in small."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, SETUP_PY, Example, manifest

NEEDED = manifest("  <exec_depend>launch</exec_depend>\n  <exec_depend>xacro</exec_depend>\n")
TESTED = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration


def late(context):
    headless = LaunchConfiguration('headless').perform(context)
    world = LaunchConfiguration('world').perform(context)
    gui = LaunchConfiguration('gui').perform(context)
    gui = gui.lower() == 'true'
    found = []
    {}
    return found


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('headless', default_value='False'),
        DeclareLaunchArgument('world', default_value='empty'),
        DeclareLaunchArgument('gui', default_value='true'),
        DeclareLaunchArgument('any'),
        OpaqueFunction(function=late),
    ])
"""
MODES = """\
arm:
  ros__parameters:
    modes:
      slow:
        {}:
          rate: 1
      fast:
        ros__parameters:
          rate: 2
"""
JOINT = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <ros2_control name="arm" type="system">
    <joint name="elbow">
      <command_interface name="effort"/>
      {}
    </joint>
  </ros2_control>
</robot>
"""


def tested(line: str) -> Example:
    return Example(bad={"package.xml": NEEDED, "launch/a.launch.py": TESTED.format(line)}, good={})


def modes(key: str, text: str = MODES) -> Example:
    return Example(bad={"config/robot.yaml": text.format(key)}, good={}, on="config")


MANAGER = "ros2 run controller_manager ros2_control_node\n"


def robot(text: str) -> Example:
    return Example(bad={"package.xml": NEEDED, "urdf/arm.urdf.xacro": text, "start.sh": MANAGER}, good={})


def xacro(line: str) -> Example:
    return robot(f'<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">\n  {line}\n</robot>\n')


def launches(files: dict[str, str]) -> Example:
    return Example(bad={"CMakeLists.txt": CMAKE, **files}, good={}, on="ament_cmake")


START = "def generate_launch_description():\n    return None\n"
YAML = "launch:\n  - arg: {name: rate, default: '2'}\n"
XML = '<launch>\n  <include file="$(find-pkg-share my_pkg)/launch/robot.launch.xml"/>\n</launch>\n'

NAV = """\
controller_server:
  ros__parameters:
    controller_plugins: [{}]
    Fast:
      plugin: a::Fast
    Slow:
      speed: 1.0
other:
  ros__parameters:
    controller_plugins: [Fast, Slow, Lost]
"""


def served(names: str, other: str = "a: 1\n") -> Example:
    package = manifest("  <exec_depend>nav2_controller</exec_depend>\n", "ament_cmake")
    files = {"config/robot.yaml": NAV.format(names), "config/b.yaml": f"/**:\n  ros__parameters:\n    {other}"}
    return Example(bad={"package.xml": package, **files}, good={}, on="config")


DOCKS = """\
docking_server:
  ros__parameters:
    dock_plugins: [{}]
    dock_x:
      plugin: opennav_docking::SimpleChargingDock
    dock_y:
      plugin: opennav_docking::SimpleChargingDock
    other:
      plugin: opennav_docking::SimpleChargingDock
"""


def docked(names: str) -> Example:
    package = manifest("  <exec_depend>opennav_docking</exec_depend>\n", "ament_cmake")
    return Example(bad={"package.xml": package, "config/robot.yaml": DOCKS.format(names)}, good={}, on="config")


CASES = {
    "PRM008": (
        served("Fast, Lost"),
        served("Fast, Lost", "Lost:\n      plugin: a::Lost\n"),
        served("Fast, FollowPath"),
        served("Fast, Slow"),
        served("Lost, Gone"),
        served("Fast, Slow, Slow", "a: 1\n"),
        served("Fast, Slow, Fast"),
        docked("dock_x, dock_x"),
        docked("dock_x, dock_y"),
        docked("dock_x, other, other"),
    ),
    "CMK101": (
        launches({"launch/start.py": START}),
        launches({"launch/start.py": "x = 1\n"}),
        launches({"config/start.py": START}),
        launches({"launch/start.txt": START}),
        launches({"launch/start.yaml": YAML}),
        launches({"launch/start.yml": "# a\n" + YAML}),
        launches({"launch/rates.yaml": "relaunch: 1\n"}),
        launches({"launch/start.xml": XML}),
        launches({"launch/tree.xml": XML.replace("launch>", "root>")}),
    ),
    "SET206": tuple(
        Example(bad={"setup.py": SETUP_PY, **files}, good={})
        for files in (
            {"launch/start.py": START},
            {"launch/start.yaml": YAML},
            {"launch/start.launch": XML},
            {"launch/rates.yaml": "relaunch: 1\n"},
            {"launch/start.py": "x = 1\n"},
        )
    ),
    "LCH014": tuple(
        tested(line)
        for line in (
            "if headless:\n        found.append(1)",
            "if not headless:\n        found.append(1)",
            "if world == 'empty' and headless:\n        found.append(1)",
            "found = [1] if headless else []",
            "if headless == 'True':\n        found.append(1)",
            "if world or gui:\n        found.append(1)",
            "if not world or +headless:\n        found.append(1)",
        )
    ),
    "PRM001": (
        modes("rot__parameters"),
        modes("ros_parameters"),
        modes("parameters"),
        modes("rot__parameters", MODES.replace("        ros__parameters", "        values")),
        Example(bad={"config/robot.yaml": "arm:\n  rot__parameters:\n    rate: 1\n"}, good={}, on="config"),
    ),
    "URD001": (
        robot(JOINT.format('<state_interface name="effor"/>')),
        robot(JOINT.format('<state_interface name="effor"/><command_interface name="effor"/>')),
        robot(JOINT.format('<state_interface name="velocit"/>')),
        robot(JOINT.format('<state_interface name="efort"/>')),
        xacro('<xacro:property name="radius" value="${1.0 * 2}}"/>'),
        xacro('<xacro:property name="radius" value="${1.0 * 2} ${3}"/>'),
        xacro('<xacro:property name="words" value="{\'a\': ${1}}"/>'),
        xacro('<link name="a${1.0 * 2}}"/>'),
        xacro('<xacro:arg name="gripper" default="$(arg gripper)"/>'),
        xacro('<xacro:arg name="gripper" default="$(arg other)"/><xacro:arg name="other" default=""/>'),
        xacro('<xacro:arg name="gripper"/>'),
    ),
}
