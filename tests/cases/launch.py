"""Sentences about launch files that no example shows."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest
from rospkg_cli.rules.launch import lch008_undeclared_launch_argument as lch008
from rospkg_cli.rules.launch import lch009_unquoted_robot_description as lch009
from rospkg_cli.rules.launch import lch011_unknown_component as lch011
from rospkg_cli.rules.launch import lch013_undefined_launch_name as lch013

LAUNCH = "launch/a.launch.py"


def component(plugin: str, package: str = "my_pkg") -> Example:
    text = lch011.BAD.replace("«my_pkg::Taker»", plugin).replace('pkg="my_pkg"', f'pkg="{package}"')
    return Example(bad={**lch011.FILES, "launch/a.launch.xml": text}, good={}, on="ament_cmake")


def python(text: str) -> Example:
    return Example(bad={"package.xml": lch013.NEEDED, LAUNCH: text.replace("«", "").replace("»", "")}, good={})


NOT_ADDED = lch008.BAD_PYTHON.replace("import LogInfo", "import DeclareLaunchArgument, LogInfo").replace(
    "    return", "    rate = DeclareLaunchArgument('rate')\n    return"
)

CASES = {
    "LCH008": (python(NOT_ADDED),),
    "LCH009": (
        Example(
            bad={
                "package.xml": manifest(lch009.NEEDED),
                "urdf/robot.urdf.xacro": '<robot name="robot"/>\n',
                LAUNCH: lch009.BAD.replace("«", "").replace("»", ""),
            },
            good={},
        ),
    ),
    "LCH011": (component("other::Camera"), component("my_pkg::Listener")),
    "LCH013": (
        python(lch013.BAD.replace("«DeclareLaunchArgument»('rate', default_value='10')", "LogInof(msg='x')")),
        python(lch013.BAD.replace("«DeclareLaunchArgument»('rate', default_value='10')", "something_else")),
    ),
}
