"""What xacro refuses while it expands a robot, and what the expanded robot lacks."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

HEAD = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"'
MANAGER = "<node pkg='controller_manager' exec='ros2_control_node'/>"
INSTALL = CMAKE.replace("ament_package", "install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\nament_package")
WHEEL = f"""\
{HEAD}>
  <xacro:property name="radius" value="0.1"/>
  <xacro:macro name="wheel" params="prefix parent side:=1 size:=^|${{radius}} *origin **more">
    <link name="${{prefix}}wheel"/>
    <joint name="${{prefix}}axle" type="continuous">
      <parent link="${{parent}}"/>
      <child link="${{prefix}}wheel"/>
      <xacro:insert_block name="origin"/>
    </joint>
    <xacro:insert_block name="more"/>
    <xacro:if value="${{side > 0}}">
      <link name="${{prefix}}cap"/>
    </xacro:if>
  </xacro:macro>
</robot>
"""
INCLUDE = '<xacro:include filename="$(find my_pkg)/urdf/wheel.xacro"/>'
BLOCKS = '<origin xyz="0 0 0"/><more/>'


OPENED = {"launch/show.xml": f"<launch><let name='model' value='urdf/robot.urdf.xacro'/>{MANAGER}</launch>\n"}


def robot(*lines: str, wheel: str = WHEEL, name: str = ' name="robot"', **more: str) -> Example:
    """A robot of a line each, that includes the macro of a wheel."""
    text = f"{HEAD}{name}>\n" + "".join(f"  {line}\n" for line in lines) + "</robot>\n"
    files = {"CMakeLists.txt": INSTALL, "urdf/robot.urdf.xacro": text, "urdf/wheel.xacro": wheel, **OPENED, **more}
    return Example(on="ament_cmake", bad=files, good={})


def call(arguments: str, blocks: str = BLOCKS, name: str = "wheel") -> str:
    return f"<xacro:{name} {arguments}>{blocks}</xacro:{name}>"


ARM = f"""\
{HEAD}>
  <xacro:macro name="arm" params="prefix parent">
    <link name="${{{{prefix}}}}upper"/>
    <link name="${{{{prefix}}}}lower"/>
    <joint name="${{{{prefix}}}}elbow" type="continuous">
      <parent link="${{{{prefix}}}}upper"/>
      <child link="{{}}"/>
    </joint>
    <joint name="${{{{prefix}}}}wrist" type="continuous">
      <parent link="{{}}"/>
      <child link="${{{{prefix}}}}hand"/>
      <mimic joint="{{}}"/>
    </joint>
    <link name="{{}}"/>
  </xacro:macro>
</robot>
"""
LOWER, ELBOW, HAND = "${prefix}lower", "${prefix}elbow", "${prefix}hand"
PREFIXES = tuple(
    robot(**{"urdf/arm.xacro": ARM.format(*names)})
    for names in (
        (LOWER, LOWER, ELBOW, HAND),
        ("lower", LOWER, ELBOW, HAND),
        (LOWER, LOWER, "elbow", HAND),
        (LOWER, "lower", ELBOW, HAND),
        ("hand", LOWER, ELBOW, HAND),
        ("ower", LOWER, ELBOW, HAND),
        ("lower", LOWER, ELBOW, "${parent}lower"),
        ("$(arg lower)", LOWER, ELBOW, HAND),
    )
)
RIGHT = robot(
    INCLUDE,
    '<link name="base"/>',
    call('prefix="left_" parent="base"'),
    call('prefix="right_" parent="base" side="0"'),
    '<joint name="j" type="fixed"><parent link="left_cap"/><child link="right_wheel"/></joint>',
)
CALLS = (
    robot(INCLUDE, '<link name="base"/>', call('prefix="a_" parnt="base"')),
    robot(INCLUDE, '<link name="base"/>', call('prefix="a_"')),
    robot(INCLUDE, '<link name="base"/>', call('prefix="a_" parent="base"', "<origin/>")),
    robot(INCLUDE, '<link name="base"/>', call('prefix="a_" parent="base"', f"{BLOCKS}<extra/>")),
    robot(INCLUDE, '<link name="base"/>', call('prefix="a_" parent="base"', "<origin/><xacro:insert_block name='x'/>")),
    robot(
        INCLUDE, '<link name="base"/>', call('prefix="a_" parent="base"', "<xacro:if value='1'><origin/></xacro:if>")
    ),
    robot(INCLUDE, call("", name="whel"), call('prefix="a_"')),
    robot(INCLUDE, call("", name="something_else")),
    robot('<xacro:arg name="base" default="b"/>', call('parent="$(arg bsae)"', name="something_else")),
    robot(call("", name="whel"), call("", name="wheel2")),
    robot('<xacro:arg name="base" default="b"/>', call('parent="$(arg bsae)"', name="front.wheel")),
    robot(
        '<xacro:if value="$(arg x)">',
        INCLUDE,
        '<xacro:macro name="arm" params=""><xacro:whel/></xacro:macro>',
        "</xacro:if>",
        '<xacro:unless value="$(arg x)">',
        '<xacro:macro name="arm" params=""><link name="b"/></xacro:macro>',
        "</xacro:unless>",
        "<xacro:arm/>",
    ),
    robot('<xacro:if value="$(arg x)">', INCLUDE, "</xacro:if>", '<link name="b"/>', call('prefix="a_" parnt="b"')),
    robot(INCLUDE, '<xacro:if value="$(arg x)">', call("", name="whel"), call("", name="wrong_arm"), "</xacro:if>"),
    robot(INCLUDE, '<xacro:include filename="$(find other)/urdf/other.xacro"/>', call("", name="whel")),
    robot(INCLUDE, '<xacro:include filename="$(find other)/urdf/other.xacro"/>', call("", name="something_else")),
)
NAMES = (
    robot(
        '<xacro:property name="length" value="${2 * width}"/>',
        '<xacro:property name="width" value="1"/>',
        '<link name="a"><visual><geometry><box size="${length} ${widht} ${pi * sin(0.5)}"/></geometry></visual></link>',
        '<link name="${[x for x in range(3)][0]}"/>',
        '<xacro:property name="lost" value="${nothing}"/>',
        '<link name="${lost}"/>',
        '<xacro:insert_block name="frame"/>',
        '<xacro:property name="shape"><box/></xacro:property>',
        '<xacro:insert_block name="shpe"/>',
        '<xacro:insert_block name="shape"/>',
    ),
    robot('<xacro:include filename="$(find other)/a.xacro"/>', '<xacro:property name="width" value="1"/>',
          '<link name="${widht}"/><link name="${nothing}"/>'),
    robot('<xacro:include filename="$(find other)/a.xacro"/>', '<xacro:property name="width" value="1"/>',
          '<link name="${widht}"/>', **{"urdf/b.xacro": f'{HEAD}><xacro:macro name="m" params="a widht"/></robot>\n'}),
    robot('<xacro:arg name="prefix" default=""/>', '<link name="$(arg prefx)a"/>', '<link name="$(arg other)a"/>'),
    robot('<xacro:if value="yes"/>', '<xacro:if value="${1 + 1}"/>', '<xacro:unless value="1.0"/>',
          '<xacro:if value="$(arg x)"/>', '<xacro:if value="True"/>', '<xacro:if value="${1.0}"/>'),
)  # fmt: skip
TREES = (
    robot(INCLUDE, '<link name="base"/>', call('prefix="a_" parent="bse"')),
    robot(INCLUDE, '<link name="base"/>', call('prefix="a_" parent="somewhere"')),
    robot(INCLUDE, '<link name="base"/>', call('prefix="a_" parent="base"'), call('prefix="a_" parent="base"')),
    robot(INCLUDE, '<link name="a_wheel"/>', call('prefix="a_" parent="a_wheel"')),
    robot(INCLUDE, '<link name="base"/>', call('prefix="a_" parent="base"'), '<gazebo reference="a_weel"/>',
          '<gazebo reference="a_wheel"/>', '<gazebo reference="somewhere"/>', '<gazebo reference="a_axle"/>'),
    robot(INCLUDE, '<link name="base"/>', call('prefix="a_" parent="base"'),
          '<ros2_control name="c" type="system"><joint name="a_axle"/><joint name="a_axel"/></ros2_control>',
          '<link name="arm"/>',
          '<joint name="j" type="fixed"><parent link="base"/><child link="arm"/><mimic joint="a_axl"/></joint>'),
    robot('<xacro:arg name="prefix" default=""/>', INCLUDE, '<link name="$(arg prefix)base"/>',
          call('prefix="$(arg prefix)" parent="$(arg prefix)bsae"'), call('prefix="b_" parent="base"')),
    robot('<xacro:arg name="parent" default="world"/>', INCLUDE, '<link name="base"/>',
          call('prefix="a_" parent="$(arg parent)"')),
    robot('<xacro:include filename="$(find other)/a.xacro"/>', INCLUDE, '<link name="base_link"/>',
          call('prefix="a_" parent="bse_link"'), call('prefix="b_" parent="somewhere"'),
          call('prefix="c_" parent="b_weel"'), call('prefix="l_" parent="base_lnik"')),
    robot('<xacro:include filename="$(find other)/a.xacro"/>', INCLUDE, '<link name="arm_head"/>',
          '<link name="elbowplate_link"/>', call('prefix="a_" parent="arm_hey5"'),
          call('prefix="b_" parent="elbwoplaet_link"')),
    robot(INCLUDE, '<link name="base"/>',
          '<xacro:if value="$(arg x)">', call('prefix="a_" parent="bse"'), "</xacro:if>",
          '<xacro:unless value="$(arg x)">', call('prefix="a_" parent="base"'), "</xacro:unless>"),
    robot(
        '<xacro:macro name="arm" params="prefix name:=x">',
        '<link name="${prefix}hand"/><link name="${prefix + \'arm\'}"/>',
        '<joint name="j" type="fixed"><parent link="${prefix}amr"/><child link="${prefix}hand"/></joint>',
        '<joint name="k" type="fixed"><parent link="${prefix}base"/><child link="${prefx}hand"/></joint>',
        "</xacro:macro>",
    ),
    robot(INCLUDE, '<link name="base"/>', call('prefix="a_" parent="bse"'), name=""),
    robot(INCLUDE, '<link name="a_wheel"/>', call('prefix="a_" parent="a_wheel"'), name=""),
)  # fmt: skip
MIMIC = (
    '<joint name="{}left" type="fixed"/><joint name="${{p}}right" type="{}"><mimic joint="{}"/></joint>'
    "<joint name='${{p}}control'/>"
)
MIMICS = tuple(
    robot('<xacro:macro name="grip" params="p">', MIMIC.format(*names), "</xacro:macro>", '<xacro:grip p=""/>')
    for names in (
        ("${p}", "fixed", "left"),
        ("${p}", "fixed", "${p}left"),
        ("${p}", "fixed", "thumb"),
        ("", "fixed", "left"),
        ("${q}", "fixed", "left"),
        ("${p}", "", "left"),
        ("${p}", "fixed", "${p}le"),
        ("${p}left_", "fixed", "${p}left"),
    )
)
CHILD = '<joint name="${{p}}{0}" type="fixed"><parent link="{1}"/><child link="{2}"/></joint>'
CHILDREN = tuple(
    robot('<xacro:macro name="grip" params="p">', *lines, "</xacro:macro>", '<xacro:grip p=""/>')
    for lines in (
        ('<link name="${p}base"/><link name="${p}tip"/>', CHILD.format("a", "world", "${p}base"),
         CHILD.format("b", "${p}base", "tip")),
        ('<link name="${p}base"/><link name="${p}tip"/>', CHILD.format("a", "world", "${p}base"),
         CHILD.format("b", "${p}base", "${p}tip"), CHILD.format("c", "${p}tip", "tip")),
        ('<link name="${p}base"/><link name="${p}tip"/><link name="tip"/>', CHILD.format("a", "world", "${p}base"),
         CHILD.format("b", "${p}base", "tip")),
    )
)  # fmt: skip
WITH_ARGUMENT = tuple(
    robot(
        '<xacro:arg name="p" default=""/>',
        '<xacro:property name="p" value="$(arg p)"/>',
        '<link name="${p}base"/><link name="${p}tip"/>',
        CHILD.format("a", "${p}base", first),
        CHILD.format(*second),
    )
    for first, *second in (
        ("tip", "b", "world", "${p}base"),
        ("${p}tip", "b", "world", "${p}base"),
        ("tip", "b", "world", "${p}tip"),
    )
)
ENDS = tuple(
    robot(
        '<link name="a"/><link name="b"/><xacro:macro name="tip" params=""><child link="b"/></xacro:macro>',
        f'<joint name="j" type="fixed">{ends}</joint>',
        *more,
    )
    for ends, *more in (
        ('<parent link="a"/>',),
        ('<child link="b"/>',),
        ('<parent link=""/><child link="b"/>',),
        ('<parent link="a"/><xacro:tip/>',),
        ('<parent link="a"/><child link="a"/>',),
        ('<parent link="a"/><child link="b"/>',),
        ("", '<ros2_control name="c" type="system"><joint name="j"/></ros2_control>'),
    )
)
WORDS = (
    robot('<link name="a"><visua/><visual><orgin xyz="0 0 0"/><geometry><sphere radius="1"/></geometry></visual>',
          '<inertial><mass value="1"/><inertai/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>',
          '<sensor/><xacro:visua/><collision_checking/></link><link name="b"/>',
          '<joint name="j" type="fixed"><parent link="a"/><child link="b"/><limits effort="1"/><axes/></joint>'),
    *(robot(f'<ros2_control name="c" type="{kind}"><joint name="j">', *(
        f'<{tag} name="{name}"/>' for tag in ("command_interface", "state_interface") for name in names),
        "</joint></ros2_control>", name=place)
      for kind, names, place in (
          ("systeem", ("position", "possition", "positions", "gripper"), ""),
          ("System", ("velcity", "efort", "accelleration"), ' name="robot"'),
          ("${kind}", ("${name}",), ""),
          ("mine", (), ""),
      )),
)  # fmt: skip
LIMITS = robot(
    '<link name="a"/><link name="b"/>',
    *(
        f'<joint name="{kind}" type="{kind}"><parent link="a"/><child link="b"/>{inside}</joint>'
        for kind, inside in (("revolute", '<xacro:property name="x" value="1"/>'), ("prismatic", "<xacro:limits/>"))
    ),
    '<xacro:macro name="limits" params=""><limit effort="1" velocity="1"/></xacro:macro>',
)
LOOSE = (
    LIMITS,
    *ENDS,
    *WORDS,
    robot('<xacro:something_else><origin xyz="0 0" rpy="0 0 0"/></xacro:something_else>', name=""),
    robot('<xacro:macro name="m" params="">', '<inertial><origin xyz="O 0 0"/><mass value="1"/></inertial>',
          '<gazebo><xacro:if value="1"><origin xyz="0"/></xacro:if></gazebo>',
          '<visual><material/></visual><inertia ixx="O"/><mass value="1" color="O"/>',
          "</xacro:macro>", "<xacro:m/>", name=""),
    robot(
        '<link name="a"><xacro:if value="1"><visual><origin rpy="0, 0 0"/><geometry><box size="1 1 1"/></geometry>'
        "</visual></xacro:if></link>",
        '<link name="b"/>',
        '<joint name="j" type="fixed"><parent link="a"/><child link="b"/>',
        '<xacro:unless value="$(arg x)"><origin xyz="0 0 O" rpy="${pi} 0 0"/></xacro:unless></joint>',
    ),
)  # fmt: skip
USED = call("prefix='a_' parent='base'") + call("prefix='a_'")
ELSEWHERE = Example(
    on="",
    bad={
        "other/package.xml": manifest("", "ament_cmake", "other"),
        "other/CMakeLists.txt": INSTALL.replace("my_pkg", "other"),
        "other/urdf/wheel.xacro": WHEEL.replace('"${parent}"', '"${parent}x"'),
        "my_pkg/package.xml": manifest("  <exec_depend>other</exec_depend>\n", "ament_cmake"),
        "my_pkg/CMakeLists.txt": INSTALL,
        "my_pkg/urdf/robot.urdf.xacro": f'{HEAD} name="robot">\n'
        '  <xacro:include filename="$(find other)/urdf/wheel.xacro"/>\n  <link name="base"/>\n'
        + f"  {USED}\n</robot>\n",
    },
    good={},
)
CASES = {"URD001": (RIGHT, *CALLS, *NAMES, *TREES, ELSEWHERE, *PREFIXES, *MIMICS, *CHILDREN, *WITH_ARGUMENT, *LOOSE)}
