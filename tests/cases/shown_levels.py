"""Levels that no example shows: each level that a rule declares is in its golden, here or elsewhere."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest, setup_py
from rospkg_cli.rules.cmake import cmk005_removed_command as cmk005
from rospkg_cli.rules.cmake import cmk105_script_not_executable as cmk105
from rospkg_cli.rules.cmake import cmk113_missing_export_dependency as cmk113
from rospkg_cli.rules.depends import dep105_undeclared_include as dep105
from rospkg_cli.rules.depends import dep107_missing_find_package as dep107
from rospkg_cli.rules.depends import dep108_undeclared_interface_package as dep108
from rospkg_cli.rules.interfaces import idl007_missing_interface_dependency as idl007
from rospkg_cli.rules.launch import lch003_missing_launch_reference as lch003
from rospkg_cli.rules.launch import lch004_reference_not_installed as lch004
from rospkg_cli.rules.launch import lch008_undeclared_launch_argument as lch008
from rospkg_cli.rules.manifest import xml004_feature_needs_format_3 as xml004
from rospkg_cli.rules.plugins import plg006_unlisted_rqt_plugin as plg006
from rospkg_cli.rules.setup import set302_package_not_installed as set302
from rospkg_cli.rules.urdf import urd001_invalid_urdf as urd001
from rospkg_cli.rules.urdf import urd002_missing_resource as urd002

from .cmake import cmake


def plain(text: str) -> str:
    return text.replace("«", "").replace("»", "")


def commented(name: str, body: str = "", build_type: str = "ament_python") -> dict[str, str]:
    """A manifest with a dependency in a comment."""
    return {"package.xml": manifest(f"{body}  <!-- <depend>{name}</depend> -->\n", build_type)}


def on_cmake(files: dict[str, str], **changed: str) -> Example:
    named = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in changed.items()}
    return Example(bad={path: plain(text) for path, text in {**files, **named}.items()}, good={}, on="ament_cmake")


def on_python(files: dict[str, str], **changed: str) -> Example:
    named = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in changed.items()}
    return Example(bad={path: plain(text) for path, text in {**files, **named}.items()}, good={})


def for_target(example: Example, target: str) -> Example:
    return Example(bad=example.bad, good={}, on=example.on, targets=(target,))


def exported(lines: str) -> Example:
    return on_cmake(cmk113.FILES, CMakeLists_DOT_txt=cmk113.cmake(cmk113.LINES + lines))


LINTERS = (
    "if(BUILD_TESTING)\n  find_package(ament_lint_auto REQUIRED)\n  ament_lint_auto_find_test_dependencies()\nendif()\n"
)
COMPONENT = 'rclcpp_components_register_node(core PLUGIN "my_pkg::Core" EXECUTABLE core_node)\n'
EXPORT = "pluginlib_export_plugin_description_file(rqt_gui {}.xml)\n"
CPP = plain(plg006.XML).replace("rqt_gui_py", "rqt_gui_cpp")
UNREAD = '<launch>\n  <arg name="file" default="$(find-pkg-share my_pkg)/launch/{}.launch.xml"/>\n</launch>\n'
ARGUMENT = UNREAD.replace("</launch>", '  <log message="$(var file)"/>\n</launch>')
BOTH = UNREAD.replace(
    "</launch>", '  <include file="$(find-pkg-share my_pkg)/launch/{}.launch.xml"/>\n</launch>'
).replace("{}", "wheels")
TAKING = '<launch>\n  <arg name="speed" default="1"/>\n  <log message="$(var speed)"/>\n</launch>\n'
HANDED = """\
<launch>
  <include file="$(find-pkg-share my_pkg)/launch/b.launch.xml">
    <arg name="robot" value="$(find-pkg-share my_pkg)/urdf/robot.urdf"/>
    <arg name="speed" value="$(find-pkg-share my_pkg)/urdf/speed.yaml"/>
  </include>
</launch>
"""
MANY = "".join(f'  <log message="$(var rate{number})"/>\n' for number in range(lch008.FEW + 1))
FEW = MANY.split("\n", 1)[1]

CASES = {
    "CMK004": (on_cmake({}, CMakeLists_DOT_txt=CMAKE + LINTERS),),
    "CMK005": tuple(
        for_target(on_cmake(cmk005.FILES, CMakeLists_DOT_txt=cmk005.ONE), name)
        for name in ("jazzy", "kilted", "lyrical", "rolling")
    ),
    "CMK105": (
        cmake(plain(cmk105.FOLDER).replace("scripts/ ", "more/ ") + plain(cmk105.PROGRAMS),
              more__a_DOT_py=cmk105.SHEBANG, scripts__hello_DOT_py=cmk105.SHEBANG),
    ),
    "CMK113": (exported(COMPONENT), exported("ament_export_include_directories(include/${PROJECT_NAME})\n")),
    "DEP101": (on_python(commented("sensor_msgs"), my_pkg__a_DOT_py="import sensor_msgs.msg\n"),),
    "DEP102": (
        on_python(commented("sensor_msgs"), test__test_a_DOT_py="import sensor_msgs.msg\n"),
    ),
    "DEP105": (
        on_cmake(commented("std_msgs", "", "ament_cmake"), CMakeLists_DOT_txt=dep105.NODE,
                 src__node_DOT_cpp="#include <std_msgs/msg/string.hpp>\n"),
        on_cmake({"package.xml": manifest("  <depend>sensor_msgs</depend>\n", "ament_cmake")},
                 CMakeLists_DOT_txt=dep105.NODE, src__node_DOT_cpp="#include <std_msgs/msg/string.hpp>\n"),
    ),
    "DEP107": (
        on_cmake({"package.xml": dep107.DECLARED}, src__node_DOT_cpp="int main() {return 0;}\n",
                 CMakeLists_DOT_txt=dep107.NODE.replace(
                     dep107.FOUND, dep107.FOUND + "find_package(some_messages REQUIRED)\n")),
    ),
    "DEP108": (
        on_cmake(commented("geometry_msgs", dep108.TOOLS + dep108.RUNTIME + dep108.GROUP, "ament_cmake"),
                 CMakeLists_DOT_txt=dep108.CMAKE_MSG, msg__Pose_DOT_msg="geometry_msgs/Pose2D pose\n"),
    ),
    "IDL007": (
        Example(
            bad={**idl007.FILES, "CMakeLists.txt": idl007.GOOD.replace("DEPENDENCIES std", "DEPENDENCIES some")},
            good={}, on="interfaces",
        ),
    ),
    "LCH003": (
        on_python(lch003.NODE, launch__a_DOT_launch_DOT_xml=ARGUMENT.format("nothing")),
        on_python(lch003.NODE, launch__a_DOT_launch_DOT_xml=UNREAD.format("nothing")),
        on_python(lch003.NODE, launch__a_DOT_launch_DOT_xml=HANDED, launch__b_DOT_launch_DOT_xml=TAKING),
    ),
    "LCH004": tuple(
        on_cmake({"package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake")},
                 CMakeLists_DOT_txt=lch004.ONE, launch__robot_DOT_launch_DOT_xml=text.format("wheels"),
                 launch__wheels_DOT_launch_DOT_xml="<launch>\n</launch>\n")
        for text in (ARGUMENT, UNREAD, BOTH)
    ),
    "LCH008": (
        on_python({"package.xml": lch008.NEEDED}, launch__a_DOT_launch_DOT_xml=f"<launch>\n{MANY}</launch>\n"),
        on_python({"package.xml": lch008.NEEDED}, launch__a_DOT_launch_DOT_xml=f"<launch>\n{FEW}</launch>\n"),
        on_python({"package.xml": lch008.NEEDED}, launch__a_DOT_launch_DOT_xml=lch008.BAD,
                  launch__b_DOT_launch_DOT_xml='<launch>\n  <include file="a.launch.xml"/>\n</launch>\n'),
    ),
    "PLG006": (
        on_cmake({
            "package.xml": plg006.LISTED.replace("ament_python", "ament_cmake"),
            "CMakeLists.txt": CMAKE.replace(
                "ament_package", EXPORT.format("plugin") + EXPORT.format("other") + "ament_package"),
            "plugin.xml": CPP,
            "other.xml": CPP.replace("Panel", "Other"),
        }),
    ),
    "SET302": (
        on_python(set302.FILES, setup_DOT_py=setup_py().replace(set302.FOUND, "[package_name]"),
                  my_pkg__talker_DOT_py="print('hello')\n"),
    ),
    "URD001": tuple(
        Example(bad={"config/robot.urdf.xacro": urd001.XACRO.replace("  <link", f"  {lines}\n  <link")}, good={},
                on="config")
        for lines in (
            '<xacro:property name="unread" value="${radius * 2"/>',
            '<xacro:property name="unread" value="${radius * 2" lazy_eval="false"/>',
            '<xacro:property name="read" value="${radius *}"/>\n  <xacro:property name="more" value="${read}"/>',
            '<xacro:if value="1">\n    <link name="${radius *}"/>\n  </xacro:if>',
            '<xacro:unless value="${radius *}">\n  </xacro:unless>',
            '<xacro:macro name="unused">\n    <link name="${radius *}"/>\n  </xacro:macro>',
            '<xacro:macro name="used">\n    <link name="${radius *}"/>\n  </xacro:macro>\n  <xacro:used/>',
        )
    ),
    "URD002": tuple(
        on_cmake(urd002.FILES, urdf__robot_DOT_urdf_DOT_xacro=urd002.GOOD.replace(
            '  <link', f'  {lines}\n  <link', 1))
        for lines in (
            '<xacro:property name="unread" value="package://my_pkg/meshes/no.stl"/>',
            '<xacro:macro name="unused">\n    <xacro:include filename="no.xacro"/>\n  </xacro:macro>',
        )
    ),
    "XML004": (
        on_python({"package.xml": plain(xml004.BAD).replace(' condition="$ROS_VERSION == 2"', "").replace(
            "<version>", '<version compatibility="1.0.0">')}),
    ),
}  # fmt: skip
