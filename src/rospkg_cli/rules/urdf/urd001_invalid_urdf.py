"""URD001 invalid-urdf."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.urdf.judged_robot import JudgedRobot
from ...edits.fault_hits import hits
from ...example import Example
from ...finding import Hit, Related, Severity
from ...light_dataclasses import replace
from ...rule import rule

GOOD = """\
<robot name="robot">
  <link name="base"/>
  <link name="wheel"/>
  <joint name="axle" type="continuous">
    <parent link="base"/>
    <child link="wheel"/>
  </joint>
</robot>
"""
XACRO = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">
  <xacro:property name="radius" value="0.1"/>
  <link name="wheel">
    <visual>
      <geometry>
        <sphere radius="${radius * 2}"/>
      </geometry>
    </visual>
  </link>
</robot>
"""
MACRO = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">
  <xacro:macro name="wheel" params="side parent">
    <link name="${side}_wheel"/>
    <joint name="${side}_axle" type="continuous">
      <parent link="${parent}"/>
      <child link="${side}_wheel"/>
    </joint>
  </xacro:macro>
  <link name="base"/>
  <xacro:wheel side="left" parent="base"/>
</robot>
"""
SHOW = """\
<launch>
  <let name="model" value="$(find-pkg-share my_pkg)/config/{}"/>
</launch>
"""


def example(bad: str, good: str, text: str = GOOD, name: str = "robot.urdf") -> Example:
    launch = {"config/show.launch.xml": SHOW.format(name)}
    return Example(
        on="config", bad={f"config/{name}": text.replace(good, bad), **launch}, good={f"config/{name}": text}
    )


@rule(
    "URD001",
    "invalid-urdf",
    over=JudgedRobot,
    severity=Severity.ERROR,
    levels={
        Severity.INFO: "no launch file is shown to open a robot that meets it, a part of a link is lost, a condition "
        "is around it, nothing calls its macro or reads its property or its `<ros2_control>`, Gazebo leaves out what "
        "is unknown, a prefix or an argument may be given, or the robot has blanks that are still to be filled in",
    },
    examples=(
        example('<parent link="«bse»"/>', '<parent link="base"/>'),
        example('  <link name="wheel"/>\n  <link name="«arm»"/>', '  <link name="wheel"/>'),
        example('  <link name="wheel"/>\n  <link name="«wheel»"/>', '  <link name="wheel"/>'),
        example('type="«revolute»"', 'type="continuous"'),
        example('radius="«${radius * 2»"', 'radius="${radius * 2}"', XACRO, "robot.urdf.xacro"),
        example("«<sphere/>»", '<sphere radius="${radius * 2}"/>', XACRO, "robot.urdf.xacro"),
        example('"«${raduis * 2}»"', '"${radius * 2}"', XACRO, "robot.urdf.xacro"),
        example('side="left" «parnt»="base"', 'side="left" parent="base"', MACRO, "robot.urdf.xacro"),
        example('side="left" parent="«bse»"', 'side="left" parent="base"', MACRO, "robot.urdf.xacro"),
    ),
)
def invalid_urdf(judged: JudgedRobot) -> Iterator[Hit]:
    """
    ## What it does
    Finds URDF files that urdfdom refuses, and xacro that can't be evaluated.
    Every joint has a type, a parent and a child that are links of the robot, a revolute or prismatic one a limit; names
    are unique; the links make one tree with one root; numbers are numbers. Joints that a `<mimic>` or a
    `<ros2_control>` names exist. A xacro file is expanded, with what it includes of this package and of others in the
    workspace: macros, properties, parameters, blocks and conditions that xacro stops at, and the links and joints that
    come out. Parts of names that an argument gives are compared as they are written.

    ## Why is this bad?
    robot_state_publisher, RViz, Gazebo and MoveIt refuse the whole robot: "Model Parsing the xml failed". What is wrong
    inside of a link loses its shapes: urdfdom prints an error and goes on without them.

    ## When it is quiet
    A joint without type, parent and child in a xacro file is none of URDF: xacro puts it into a `<ros2_control>`, a
    transmission or an SRDF. A macro is expanded only where it is called, a property evaluated only where `${…}` reads
    it, what is in `<xacro:if>` only for some: there the level is lower. Where a file may be a part of a robot, or
    something that it includes is not here, names that it lacks are reported only where a near one is there, or one with
    a prefix (`${prefix}hand` for `hand`) that is no joint's child; that is an info. So is `${…}` in a `.urdf` without
    xacro's elements that no launch file gives to xacro. What a macro takes is not known behind an include of a computed
    name (`${type}.urdf.xacro`), where a file of the package that it may be defines it again. A fault is an error only
    where a launch file of the workspace, one that is installed or named, names a robot in which xacro meets it: its
    folder and those of includes count, and calls of macros. Where code, a command of a page, an action that is off by
    default or nothing opens the robot (a launch file that puts its name together only may), it is an info; so it is in
    a folder such as `old/`, in a macro that nothing calls, where urdfdom or xacro skip it, or meet it in some runs,
    and in a `<ros2_control>` where no package here names, needs or starts a controller manager or a simulator. Joints
    of a `<ros2_control>` that the robot lacks are one where pages and scripts name Humble or older ones alone and no
    plugin for Gazebo moves them, and an argument that is its own default where no launch file is known to leave it out.
    In a robot with blanks for names or values (`TODO`, `___`, `FILL_ME`), which an exercise or a template leaves, all
    are.

    ## References
    ros/urdfdom: urdf_parser/src; ros/xacro: substitution_args.py
    """
    for fault, others in judged.found():
        for hit in hits(judged.robot.path, [fault]):
            again = tuple(Related(path, span, "here too") for path, span in others)
            yield replace(hit, related=(*hit.related, *again))
