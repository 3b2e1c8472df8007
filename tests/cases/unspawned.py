"""Controllers of a parameter file where launch files load some or none, and what xacro fills in."""

from __future__ import annotations

from rospkg_cli.example import SETUP_PY_FOR_ALL, Example, manifest

TYPES = """\
controller_manager:
  ros__parameters:
    arm:
      type: joint_trajectory_controller/JointTrajectoryController
"""
LAUNCH = """\
<launch>
  <node pkg="controller_manager" exec="ros2_control_node">
    <param from="$(find-pkg-share my_pkg)/config/arm.yaml"/>
  </node>
{}</launch>
"""
ROBOT = """\
<robot name="robot">
  <gazebo>
    <plugin filename="libgazebo_ros2_control.so" name="control">
      <parameters>$(find ur_description)/config/arm.yaml</parameters>
    </plugin>
  </gazebo>
</robot>
"""
NEEDS = manifest("  <exec_depend>controller_manager</exec_depend>\n  <exec_depend>ros2launch</exec_depend>\n")


def starts(more: str) -> Example:
    files = {"package.xml": NEEDS, "setup.py": SETUP_PY_FOR_ALL, "config/arm.yaml": TYPES}
    return Example(bad={**files, "launch/arm.launch.xml": LAUNCH.format(more)}, good={}, on="config")


CASES = {
    "DEP106": (
        starts(""),
        starts('  <!-- <node pkg="controller_manager" exec="spawner" args="arm"/> -->\n'),
        starts('  <node pkg="controller_manager" exec="spawner" args="arm"/>\n'),
        starts('  <include file="$(find-pkg-share my_pkg)/launch/spawn.launch.xml"/>\n'),
        Example(bad={"urdf/robot.urdf.xacro": ROBOT}, good={}),
    ),
}
