"""What xacro meets in a file is as grave as in the robots that reach it (URD001, URD002): their folders count."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
INSTALL = CMAKE.replace("ament_package", "install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\nament_package")
BEAM = f"""\
<robot {XACRO}>
  <xacro:macro name="beam" params="prefix name"><link name="${{prefix}}${{name}}"/></xacro:macro>
</robot>
"""
CHASSIS = f"""\
<robot {XACRO}>
  <xacro:include filename="../beam.xacro"/>
  <xacro:macro name="chassis" params="prefix">
    <xacro:beam name="front" {{}}/>
    {{}}
  </xacro:macro>
</robot>
"""
LACKS, GIVES = CHASSIS.format("", ""), CHASSIS.format('prefix="${prefix}"', "")
NO_FILE = CHASSIS.format('prefix="${prefix}"', '<xacro:include filename="none.xacro"/>')
ROBOT = f'<robot {XACRO} name="r">\n  <xacro:include filename="{{}}chassis.xacro"/>\n  {{}}\n</robot>\n'
CALL = '<xacro:chassis prefix="a_"/>'
FOUND = "$(find my_pkg)/urdf/{}/"
NAMES = "import launch\n\nURDF = {}\n"
SECOND = "launch/show.launch.py"


def robots(old: str = LACKS, include: str = FOUND, call: str = CALL, **more: str) -> Example:
    """Two robots, of which a launch file opens `v2`; the chassis of `v1` is another file of its name."""
    named = {name.replace("__", "/").replace("_DOT_", "."): content for name, content in more.items()}
    files = {
        "CMakeLists.txt": INSTALL,
        "urdf/beam.xacro": BEAM,
        "urdf/v1/chassis.xacro": old,
        "urdf/v2/chassis.xacro": GIVES,
        "urdf/v1.urdf.xacro": ROBOT.format(include.format("v1"), call),
        "urdf/v2.urdf.xacro": ROBOT.format(include.format("v2"), CALL),
        SECOND: NAMES.format("'urdf', 'v2.urdf.xacro'"),
    }
    return Example(bad={**files, **named}, good={}, on="ament_cmake")


OPENINGS = (
    {},
    {"README.md": "Type `ros2 launch x y model:=v1.urdf.xacro`\n"},
    {"scripts__show_DOT_sh": "xacro urdf/v1.urdf.xacro\n"},
    {"launch__other_DOT_launch_DOT_py": NAMES.format("'urdf', 'v1.urdf.xacro'")},
    {"launch__other_DOT_launch_DOT_py": NAMES.format("f'urdf/{version}.urdf.xacro'")},
    {"urdf__whole_DOT_urdf_DOT_xacro": ROBOT.format("", "").replace("chassis", "v1.urdf")},
)
"""What opens `v1`: nothing, a page, a script, a launch file, one that puts a name together, an idle robot."""
FOLDERS = (*(robots(**each) for each in OPENINGS), *(robots(include="{}/", **each) for each in OPENINGS[:4]))
INCLUDES = tuple(robots(NO_FILE, **each) for each in OPENINGS)
COMPUTED = (
    robots(include="$(find my_pkg)/urdf/$(arg kind)/"),
    robots(include="$(find my_pkg)/lib/{}/"),
    robots(include="$(find other)/urdf/{}/"),
    robots(include="${{root}}/urdf/{}/"),
)
MOUNT = BEAM.replace(
    "</robot>", '<xacro:macro name="mount" params="name"><xacro:beam name="${name}"/></xacro:macro>\n</robot>'
)
CALLED = '<xacro:mount name="b"/>'


def mounts(v1: str = "", v2: str = "", **more: str) -> Example:
    """A macro that lacks a parameter, in a file that both robots include."""
    named = {f"urdf__{name}_DOT_urdf_DOT_xacro": ROBOT.format(f"{name}/", f"{CALL}{text}")
             for name, text in (("v1", v1), ("v2", v2))}  # fmt: skip
    return robots(GIVES, urdf__beam_DOT_xacro=MOUNT, **{**named, **more})


MACROS = (
    mounts(),
    mounts(v1=CALLED),
    mounts(v2=CALLED),
    mounts(v2=f"<!-- {CALLED} -->"),
    mounts(v2=f'<xacro:if value="$(arg more)">{CALLED}</xacro:if><xacro:arg name="more" default="1"/>'),
    mounts(v1=CALLED, launch__other_DOT_launch_DOT_py=NAMES.format("'urdf', 'v1.urdf.xacro'")),
)


def beside(text: str) -> Example:
    """A macro that lacks a parameter, and a robot of another package that may call it."""
    own = mounts()
    files = {f"my_pkg/{name}": content for name, content in own.bad.items()}
    files["my_pkg/package.xml"] = manifest(build_type="ament_cmake")
    files["other/package.xml"] = manifest(build_type="ament_cmake", name="other")
    files["other/CMakeLists.txt"] = INSTALL.replace("my_pkg", "other")
    files["other/urdf/arm.urdf.xacro"] = text
    return Example(bad=files, good={}, on="")


BEAMS = ROBOT.format("$(find my_pkg)/urdf/", "{}").replace("chassis", "beam")
OTHERS = tuple(beside(BEAMS.format(each)) for each in ("", CALLED))

CASES = {"URD001": (*FOLDERS, *COMPUTED, *MACROS, *OTHERS), "URD002": INCLUDES}
