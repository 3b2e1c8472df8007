"""What a helper hands on to launch, and what an include of a computed name may define."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest

from .setups import python
from .shown_xacro import HEAD, robot
from .told_repairs_of_python import INCLUDED, LAUNCHES

HELPED = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, SetEnvironmentVariable
from launch_pal.include_utils import include_launch_py_description, include_scoped_launch_py_description


def generate_launch_description():
    return LaunchDescription([{}('my_pkg', ['launch', 'b.launch.py'], {})])
"""
NEEDS = "  <exec_depend>launch_pal</exec_depend>\n  <exec_depend>launch</exec_depend>\n"
SCOPED, PLAIN = "include_scoped_launch_py_description", "include_launch_py_description"
GIVEN = "{'mood': DeclareLaunchArgument('tone'), 'mode': 'fast'}"
HANDED = (
    (SCOPED, f"launch_arguments={GIVEN}"),
    (SCOPED, "launch_arguments={'mood': 1}"),
    (SCOPED, f"launch_arguments={GIVEN}, env_vars=[SetEnvironmentVariable('A', 'b')], namespace='arm'"),
    (PLAIN, f"launch_arguments={GIVEN}"),
    (PLAIN, "launch_arguments={'mood': 'a'}.items(), namespace='arm'"),
)


def helped(helper: str, arguments: str) -> Example:
    """A launch file that includes one by a function that hands on its arguments, or their items."""
    files = {"launch/a.launch.py": HELPED.format(helper, arguments), "launch/b.launch.py": INCLUDED}
    return python({**files, "package.xml": manifest(NEEDS), "setup.py": LAUNCHES})


SENSOR = f"""\
{HEAD}>
  <xacro:macro name="sensor" params="name type">
    <xacro:include filename="$(find my_pkg)/urdf/{{}}"/>
    <xacro:sensor name="${{{{name}}}}"/>
  </xacro:macro>
</robot>
"""
OF_A_TYPE = f"""\
{HEAD}>
  <xacro:macro name="{{}}" params="name"><link name="${{{{name}}}}"/></xacro:macro>
</robot>
"""
CALL = '<xacro:include filename="$(find my_pkg)/urdf/wheel.xacro"/><link name="a"/>'
REDEFINED = (
    ("${type}.urdf.xacro", "sensor"),
    ("${type}.urdf.xacro", "other"),
    ("${type * 2}.urdf.xacro", "sensor"),
    ("${type}.sdf.xacro", "sensor"),
    ("laser.urdf.xacro", "sensor"),
)


def redefined(path: str, name: str) -> Example:
    """A macro that includes a file, which may define it again, and calls what it then is."""
    return robot(CALL, wheel=SENSOR.format(path), **{"urdf/laser.urdf.xacro": OF_A_TYPE.format(name)})


OF_ADA = '<xacro:include filename="/home/ada/ws/src/arm/urdf/arm.xacro"/>'
OF_INSTALLED = '<xacro:include filename="/home/ada/ws/install/arm/share/arm/urdf/arm.xacro"/>'
SHOWN = '<link name="a"><visual><geometry><mesh filename="file:///home/ada/a.stl"/></geometry></visual></link>'
PERSONAL = ((OF_ADA, '<link name="a"/>'), (OF_INSTALLED, '<link name="a"/>'), (OF_ADA, SHOWN), (SHOWN,))

CASES = {
    "LCH014": tuple(helped(*each) for each in HANDED),
    "LCH015": tuple(helped(SCOPED, f"launch_arguments={each}") for each in (GIVEN, "{'mode': 'fast'}")),
    "URD002": tuple(robot(*each) for each in PERSONAL),
    "URD001": tuple(redefined(*each) for each in REDEFINED),
}
