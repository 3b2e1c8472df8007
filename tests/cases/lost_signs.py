"""Expressions of xacro without their `$` (URD001): those that are reckoned with, and one slip in several places."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
INSTALL = CMAKE.replace("ament_package", "install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\nament_package")
ARM = f"""\
<robot {XACRO} name="r">
  <xacro:arg name="reach" default="1"/>
  <xacro:property name="wide" value="1"/>
  <xacro:macro name="bar" params="size"><a b="{{}}"/></xacro:macro>
  <xacro:bar size="1"/>
  <gazebo>{{}}</gazebo>
</robot>
"""


def arms(*texts: str, macro: str = "", launches: str = "'a0.urdf.xacro', 'a1.urdf.xacro'", **more: str) -> Example:
    """Robots of a folder, each with a text of Gazebo."""
    robots = {f"urdf/a{n}.urdf.xacro": ARM.format(macro, each) for n, each in enumerate(texts)}
    named = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in more.items()}
    launch = {"launch/show.launch.py": f"import launch\n\nURDF = {launches}\n"}
    return Example(bad={"CMakeLists.txt": INSTALL, **launch, **robots, **named}, good={}, on="ament_cmake")


MAX = "<max>{}</max>"
VALUES = (
    "{-pi}",
    "{2 * pi}",
    "{-1.5*wide/2}",
    "{pi + wide}",
    "{reach}",
    "{-reach}",
    "{f(pi)}",
    "{2}",
    "{$pi}",
    "${-pi}",
)
SLIPS = "".join(MAX.format(each) for each in ("{-2*pi}", "{2*pi}", "{-pi}", "{pi}", "{pi}"))
CASES = {
    "URD001": (
        arms("".join(MAX.format(each) for each in VALUES)),
        *(arms(MAX.format(each)) for each in VALUES),
        *(arms("", macro=each) for each in ("{size}", "a {-size}", "0 -{2 * size} 0", "{size} {-size}")),
        arms(SLIPS, SLIPS, SLIPS.replace("pi", "wide")),
        arms(SLIPS, SLIPS, launches="'a0.urdf.xacro'"),
        arms(MAX.format("{pi}"), urdf__b__a_DOT_urdf_DOT_xacro=ARM.format("", MAX.format("{pi}"))),
    )
}
