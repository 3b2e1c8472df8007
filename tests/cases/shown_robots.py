"""Sentences and silences of the rules for robots: elements, numbers, trees, substitutions."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
MANAGER = "<node pkg='controller_manager' exec='ros2_control_node'/>"


def robot(*lines: str, suffix: str = "urdf", opening: str = '<robot name="r">', **more: str) -> Example:
    """A robot of some lines, below `config/`."""
    text = "".join(f"  {line}\n" for line in lines)
    files = {f"config/{name}.xacro": text for name, text in more.items()}
    files["launch/show.xml"] = f"<launch><let name='model' value='config/robot.{suffix}'/>{MANAGER}</launch>\n"
    return Example(bad={f"config/robot.{suffix}": f"{opening}\n{text}</robot>\n", **files}, good={}, on="config")


def xacro(*lines: str, name: str = ' name="r"', **more: str) -> Example:
    return robot(*lines, suffix="urdf.xacro", opening=f"<robot {XACRO}{name}>", **more)


def links(*inside: str) -> tuple[str, ...]:
    return tuple(f'<link name="l{number}">{each}</link>' for number, each in enumerate(inside))


def visual(*shapes: str) -> tuple[str, ...]:
    return tuple(f"<visual><geometry>{each}</geometry></visual>" for each in shapes)


def joint(inside: str = "", kind: str = "fixed", parent: str = "a", child: str = "b", name: str = "j") -> str:
    given = f' type="{kind}"' if kind else ""
    return f'<joint name="{name}"{given}><parent link="{parent}"/><child link="{child}"/>{inside}</joint>'


def joints(*inside: str, kinds: tuple[str, ...] = ("fixed",)) -> tuple[str, ...]:
    """Joints of links that another file may have, each of its own name."""
    every = [(each, kind) for each in inside for kind in kinds]
    return tuple(joint(each, kind, f"${{p{n}}}", f"${{c{n}}}", f"j{n}") for n, (each, kind) in enumerate(every))


TWO = '<link name="a"/><link name="b"/>'
LIMIT = '<limit effort="1" velocity="1"/>'

SHAPES = (
    "",
    "<box/>",
    '<box size="1 2"/>',
    '<box size="1 2 3"/>',
    '<box size="1 2 x"/>',
    '<box size="1  2 3"/>',
    "<sphere/>",
    '<sphere radius="x"/>',
    '<sphere radius="0.1"/>',
    '<cylinder radius="1"/>',
    '<cylinder length="1"/>',
    "<mesh/>",
    '<cylinder length="1" radius="1."/>',
    '<mesh filename="file:///a.stl" scale="1 1"/>',
    "<capsule/>",
    "<cone/>",
    '<mesh filename="file:///a.stl" scale="1 1 1"/>',
    "<my:shape/>",
    '<sphere radius="1e3"/>',
    '<sphere radius="inf"/>',
    '<sphere radius="1e999"/>',
    '<sphere radius=" .5"/>',
    '<sphere radius="-"/>',
    '<sphere radius="1 "/>',
    '<box size="1&#10;2 3"/>',
    '<box size=""/>',
    '<sphere radius=""/>',
)
LINKS = (
    "<visual/>",
    "<collision/>",
    '<collision><origin xyz="0 0"/><geometry><cone/></geometry></collision>',
    '<visual><origin xyz="0 0 0" rpy="0 x 0"/><geometry><box size="1 1 1"/></geometry></visual>',
    '<visual><geometry><box size="1 1 1"/></geometry><material/></visual>',
    '<visual><geometry><box size="1 1 1"/></geometry><material name="red"/></visual>',
    '<collision><geometry><box size="1 1 1"/></geometry><material/></collision>',
    "<inertial/>",
    '<inertial><mass/><inertia ixx="1"/></inertial>',
    '<inertial><mass value="x"/></inertial>',
    '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>',
    '<inertial><origin rpy="0"/><mass value="1"/></inertial>',
    "<something/>",
)
PARTS = (
    '<origin xyz="1 2"/>',
    '<axis xyz="1 0"/>',
    "<axis/>",
    LIMIT,
    '<limit effort="1"/>',
    '<limit velocity="x"/>',
    '<limit effort="1" velocity="1" lower="x" upper="2"/>',
    "<safety_controller/>",
    '<calibration rising="x"/>',
    '<safety_controller k_velocity="1" soft_lower_limit="x"/>',
    "<calibration/>",
    "<mimic/>",
    "<dynamics/>",
    '<mimic joint="j"/>',
    '<mimic joint="k"/>',
    '<mimic joint="j" multiplier="x" offset="1"/>',
    '<dynamics damping="x"/>',
    '<dynamics friction="1"/>',
    "<unknown/>",
)
KINDS = ("revolute", "continuous", "prismatic", "fixed", "floating", "planar", "hinge", "")
TREES = (
    '<link name="a"/><link name="b"/><link name="c"/>' + joint(),
    TWO + '<link name="c"/>' + joint() + joint(parent="c", name="k"),
    TWO + joint() + joint(parent="b", child="a", name="k"),
    TWO
    + '<link name="c"/><link name="d"/>'
    + joint()
    + joint(parent="c", child="d", name="k")
    + joint(parent="d", child="c", name="m"),
    TWO + joint(parent="x") + '<link name="c"/>',
    TWO + joint(parent="aa", child="cc"),
    TWO + '<joint name="j" type="fixed"><child link="b"/></joint>',
    TWO + '<joint name="j" type="fixed"><parent/><child link=""/></joint>',
    TWO + '<joint type="fixed"><parent link="a"/></joint>',
    TWO + joint() + joint(),
    TWO + joint() + '<link/><material/><material name="m"/><material name="m"/>',
    TWO + joint() + '<ros2_control><joint name="j"/><joint name="i"/><joint/><sensor name="x"/></ros2_control>',
    TWO + joint() + '<transmission><joint name="i"/></transmission>',
    '<link name="a"/><link name="a"/>',
    "",
    "<gazebo/>",
)
EXPRESSIONS = (
    "${1 + 1}",
    "${1 +}",
    "${",
    "$(find my_pkg",
    "$(find)",
    "$(find a b)",
    "$(find-pkg-share my_pkg)",
    "$(var a)",
    "$()",
    "$(arg a)",
    "$(arg)",
    "$(env A B)",
    "$(optenv A)",
    "$(optenv A b c)",
    "$(dirname)",
    "$(dirname a)",
    "$(eval 1 +)",
    "$(cwd)",
    "$(cwd a)",
    "$(anon a)",
    "$${1 +}",
    "$",
    "a $ b",
    "${'{'}",
    "${a[$(arg b)]}",
    "$(find $(arg a))",
    "${ 1}",
    "$(arg_ a)",
    "$(finds a)",
    "${1 +&#32;}",
    "package://$(find my_pkg)/a.stl",
    "package://my_pkg/${x",
    "${x}${y +}",
    "${" + "x" * 30 + " * " + "y" * 30,
)
SOFT = (
    '<xacro:if value="1">{}</xacro:if>',
    '<xacro:unless value="1">{}</xacro:unless>',
    '<xacro:macro name="unused">{}</xacro:macro>',
    '<xacro:macro name="used">{}</xacro:macro><xacro:used/>',
    '<xacro:macro name="xacro:old">{}</xacro:macro><xacro:old/>',
    '<xacro:macro name="spaced">{}</xacro:macro><xacro:ns.spaced/>',
    "<xacro:macro>{}</xacro:macro>",
    '<xacro:property name="unread">{}</xacro:property>',
    '<xacro:property name="read">{}</xacro:property><xacro:insert_block name="read"/>',
    '<xacro:property name="lazy" lazy_eval="false">{}</xacro:property>',
    '<xacro:if value="1"><xacro:macro name="unused">{}</xacro:macro></xacro:if>',
    '<xacro:macro name="used"><xacro:if value="1">{}</xacro:if></xacro:macro><xacro:used/>',
    "<group>{}</group>",
)
WRONG = '<link name="${1 +}"/>'
CONTROLLED = '<ros2_control name="c" type="system"><joint name="i"/></ros2_control>'
FOLDERS = "install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\nament_package"
PATHS = (
    "package://my_pkg/meshes/a.stl",
    "package://my_pkg/urdf/robt.urdf",
    "package://my_pkg/urdf/b.stl",
    "package://my_pkg/",
    "package://my_pkg/../a.stl",
    "package://other_pkg/a.stl",
    "package://${name}/a.stl",
    "package://my_pkg/urdf/${name}.stl",
    "file://$(find my_pkg)/meshes/b.stl",
    "package://my_pkg/meshes/a.stl",
    "package://my_pkg/src/c.stl",
    "package://my_pkg/urdf",
    "package://my_pkg/top.stl",
    "meshes/a.stl",
)
FILES = {
    "CMakeLists.txt": CMAKE.replace("ament_package", FOLDERS),
    "urdf/b.stl": "solid b\n",
    "src/c.stl": "solid c\n",
    "urdf/d.stl": "solid d\n",
    "top.stl": "solid top\n",
    "README.md": "Show robot.urdf.xacro\n",
}


OPENED = {"launch/show.xml": f"<launch><let name='model' value='urdf/robot.urdf.xacro'/>{MANAGER}</launch>\n"}


def resources(*lines: str, **files: str) -> Example:
    text = "".join(f"  {line}\n" for line in lines)
    robots = {"urdf/robot.urdf.xacro": f'<robot {XACRO} name="r">\n{text}</robot>\n'}
    named = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in files.items()}
    return Example(bad={**FILES, **OPENED, **robots, **named}, good={}, on="ament_cmake")


HOMES = (
    "file:///home/ada/ws/install/ur_description/share/ur_description/meshes/a.stl",
    "/root/ws/src/a.dae",
    "C:\\Users\\ada\\a.obj",
    "file://$(find my_pkg)/a.stl",
    "/home/${user}/a.stl",
    "/opt/ros/a.stl",
    "/home/ada",
)
CASES = {
    "URD001": (
        xacro(*links(*visual(*SHAPES))),
        xacro(*links(*LINKS)),
        xacro(*links(*visual(*SHAPES[:6], '<box><xacro:size/></box>', '<sphere radius="${r}"/>',
                             '<sphere><xacro:insert_block name="r"/></sphere>', "<xacro:shape/>"))),
        xacro(*links('<visual><xacro:geometry/></visual><inertial><xacro:mass/></inertial>',
                     '<visual xacro:a="b"/><visual><geometry><box size="1 1 1"/></geometry><material>'
                   '<xacro:colour/></material></visual>')),
        xacro(TWO, *joints(*PARTS)),
        xacro(TWO, *joints("", kinds=KINDS), *joints(LIMIT, kinds=KINDS)),
        xacro(TWO, *joints('<axis xyz="1"/>', kinds=KINDS)),
        xacro(TWO, *joints("<xacro:more/>", kinds=KINDS), joint('<mimic><xacro:x/></mimic>'),
              joint('<dynamics><xacro:x/></dynamics>'), joint(kind="${kind}"), joint('<limit xacro:x="y"/>')),
        xacro('<joint name="only"/>', '<joint name="typed" type="fixed"/>',
              '<joint name="x"><parent link="a"/></joint>'),
        *(robot(each) for each in TREES),
        *(xacro(each) for each in TREES[:12]),
        *(xacro(each, name="") for each in TREES[:7]),
        robot(TWO, joint(), opening='<robot version="2.0">'),
        robot(TWO, joint(), opening='<robot name="r" version="1.1">'),
        Example(bad={"config/robot.urdf": "<robt/>\n"}, good={}, on="config"),
        Example(bad={"config/robot.urdf.xacro": "<robt/>\n"}, good={}, on="config"),
        Example(bad={"config/robot.sdf": "<robt/>\n"}, good={}, on="config"),
        xacro(*(f'<link name="{each}"/>' for each in EXPRESSIONS)),
        xacro(*(f"<gazebo>{each}</gazebo>" for each in EXPRESSIONS if "&" not in each)),
        robot(*(f'<link name="{each}"/>' for each in EXPRESSIONS[:3])),
        *(xacro(each.format(WRONG)) for each in SOFT),
        xacro('<xacro:macro name="there">' + WRONG + "</xacro:macro>",
              other=f"<robot {XACRO}>\n  <xacro:there/>\n</robot>\n"),
        xacro('<xacro:if value="${1 +}"/>', '<xacro:property name="p" value="${1 +}"/>',
              '<xacro:property name="q" value="${1 +}"/><link name="${q * 2}"/>'),
        xacro(TWO, joint(), CONTROLLED),
        xacro(TWO, joint(), CONTROLLED, name=""),
        xacro(TWO, joint(), CONTROLLED, whole=f'<robot {XACRO}><xacro:include filename="robot.urdf.xacro"/></robot>\n'),
        xacro(TWO, joint(parent="x"), '<xacro:property name="p" value="1"/>', '<xacro:arg name="q" default="1"/>'),
        xacro(TWO, joint(parent="x"), "<xacro:more/>"),
        xacro(TWO, joint(parent="${x}")),
        xacro(TWO, '<link name="${c}"/>', joint(parent="x")),
        *(Example(bad={"web/public/robot.urdf": '<robot name="r"/>\n', path: "{}\n"}, good={}, on="config")
          for path in ("web/package.json", "web/other.json", "package.json")),
    ),
    "URD002": (
        resources(*(f'<link name="l{number}"><visual><geometry><mesh filename="{each}"/></geometry></visual></link>'
                    for number, each in enumerate(PATHS))),
        resources('<xacro:include filename="robt.urdf.xacro"/>', '<xacro:include filename="../nothing.xacro"/>',
                  '<xacro:include filename="../../outside.xacro"/>',
                  '<xacro:include filename="$(find my_pkg)/a.xacro"/>',
                  '<xacro:include filename="nothing.xacro"/>', '<xacro:include filename="nothing.xacro"/>'),
        resources('<xacro:include filename="gone/a.xacro"/>', '<xacro:include filename="gone/b.xacro"/>',
                  '<gazebo><uri>package://my_pkg/gone/c.dae</uri></gazebo>'),
        resources(*(f'<gazebo><uri> {each}</uri></gazebo>' for each in HOMES[1:]),
                  f'<link name="l"><visual><geometry><mesh filename="{HOMES[0]}"/></geometry></visual></link>'),
        resources(f"<gazebo><uri>{HOMES[0]}</uri></gazebo>"),
    ),
}  # fmt: skip
