"""URD001 invalid-urdf."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.urdf.judged_robot import JudgedRobot
from ...edits.fault_hits import hits
from ...example import Example
from ...finding import Hit, Severity
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


def example(bad: str, good: str, text: str = GOOD, name: str = "robot.urdf") -> Example:
    return Example(on="config", bad={f"config/{name}": text.replace(good, bad)}, good={f"config/{name}": text})


@rule(
    "URD001",
    "invalid-urdf",
    over=JudgedRobot,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "the robot is read without a part of a link, or a condition or unused macro is around it",
        Severity.INFO: "nothing reads the property that can't be evaluated",
    },
    examples=(
        example('<parent link="«bse»"/>', '<parent link="base"/>'),
        example('  <link name="wheel"/>\n  <link name="«arm»"/>', '  <link name="wheel"/>'),
        example('  <link name="wheel"/>\n  <link name="«wheel»"/>', '  <link name="wheel"/>'),
        example('type="«revolute»"', 'type="continuous"'),
        example('radius="«${radius * 2»"', 'radius="${radius * 2}"', XACRO, "robot.urdf.xacro"),
        example("«<sphere/>»", '<sphere radius="${radius * 2}"/>', XACRO, "robot.urdf.xacro"),
    ),
)
def invalid_urdf(judged: JudgedRobot) -> Iterator[Hit]:
    """
    ## What it does
    Finds URDF files that urdfdom refuses, and xacro that can't be evaluated.
    Every joint has a type, a parent and a child that are links of the robot, a revolute or prismatic one a limit; names
    are unique; the links make one tree with one root; numbers are numbers. Joints that a `<mimic>` or a
    `<ros2_control>` names exist. In xacro files what is written literally is checked, and `${…}` and `$(…)` that xacro
    can't evaluate.

    ## Why is this bad?
    robot_state_publisher, RViz, Gazebo and MoveIt refuse the whole robot: "Model Parsing the xml failed". What is wrong
    inside of a link loses its shapes: urdfdom prints an error and goes on without them.

    ## When it is quiet
    A joint without type, parent and child in a xacro file is none of URDF: xacro puts it into a `<ros2_control>`, a
    transmission or an SRDF. A macro is expanded only where it is called, a property evaluated only where `${…}` reads
    it, what is in `<xacro:if>` only for some: there the level is lower. Joints that another file of the robot may
    have are not missed.

    ## References
    ros/urdfdom: urdf_parser/src; ros/xacro: substitution_args.py
    """
    yield from hits(judged.robot.path, judged.faults())
