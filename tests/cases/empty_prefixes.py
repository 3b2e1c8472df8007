"""Names that lack the prefix of their macro, by what its calls give (URD001)."""

from __future__ import annotations

from rospkg_cli.example import Example

HEAD = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"'
ARM = f"""\
{HEAD}>
  <xacro:macro name="arm" params="{{}} parent">
    <link name="${{{{prefix}}}}upper"/>
    <link name="${{{{prefix}}}}lower"/>
    <joint name="${{{{prefix}}}}elbow" type="fixed">
      <parent link="${{{{prefix}}}}upper"/>
      <child link="lower"/>
    </joint>
  </xacro:macro>
</robot>
"""
LAUNCH = "<launch><let name='model' value='$(find-pkg-share my_pkg)/config/{}'/></launch>\n"
UNNAMED = f'{HEAD}>\n  <xacro:include filename="arm.xacro"/>\n  <link name="base"/>\n  {{}}\n</robot>\n'
"""A robot without a name is judged as a part: nothing says what else it has."""


def called(*calls: str, params: str = "prefix", more: str = "") -> Example:
    files = {
        "config/arm.xacro": ARM.format(params).replace("{{", "{").replace("}}", "}"),
        "config/robot.xacro": UNNAMED.format(more + "".join(f'<xacro:arm parent="base" {each}/>' for each in calls)),
        "launch/show.launch.xml": LAUNCH.format("robot.xacro"),
    }
    return Example(bad=files, good={}, on="config")


ARGUMENT = '<xacro:arg name="prefix" default="{}"/>'
PROPERTY = '<xacro:property name="side" value="{}"/>'
CASES = {
    "URD001": (
        called('prefix=""'),
        called("prefix=''", 'prefix="left_"'),
        called(),
        called("", params="prefix:=''"),
        called("", params="prefix:=left_"),
        called('prefix=""', params="prefix:=left_"),
        *(called('prefix="$(arg prefix)"', more=ARGUMENT.format(each)) for each in ("", "left_")),
        *(called('prefix="${side}"', more=PROPERTY.format(each)) for each in ("", "left_")),
    )
}
