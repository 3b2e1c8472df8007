"""Levels of what only some suffer: a condition that is off, an action that nothing adds, a macro that nothing calls."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest
from rospkg_cli.rules.launch import lch002_unknown_executable as lch002
from rospkg_cli.rules.launch import lch003_missing_launch_reference as lch003
from rospkg_cli.rules.launch import lch011_unknown_component as lch011
from rospkg_cli.rules.launch import lch014_invalid_launch_call as lch014
from rospkg_cli.rules.params import prm002_duplicate_parameter as prm002
from rospkg_cli.rules.params import prm003_unknown_parameter_node as prm003
from rospkg_cli.rules.params import prm007_unknown_parameter as prm007
from rospkg_cli.rules.plugins import plg002_unexported_plugin as plg002

OFF = """\
<launch>
  <arg name="sim" default="false"/>
  <node pkg="my_pkg" exec="taker" if="$(var sim)"/>
</launch>
"""
OFF_CONTAINER = (
    lch011.BAD.replace("«", "")
    .replace("»", "")
    .replace("<launch>", '<launch>\n  <arg name="sim" default="false"/>')
    .replace(' namespace=""', ' namespace="" if="$(var sim)"')
)
LOST_CONTAINER = """\
from launch import LaunchDescription
from launch_ros.actions import ComposableNodeContainer
from launch_ros.descriptions import ComposableNode


def generate_launch_description():
    container = ComposableNodeContainer(
        package='rclcpp_components', executable='component_container', name='c', namespace='',
        composable_node_descriptions=[ComposableNode(package='my_pkg', plugin='my_pkg::Taker')])
    return LaunchDescription([])
"""
LOST_EXPRESSION = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration, PythonExpression


def generate_launch_description():
    headless = LaunchConfiguration('headless')
    log = LogInfo(msg='up', condition=IfCondition(PythonExpression(['not ', headless])))
    return LaunchDescription([DeclareLaunchArgument('headless', default_value='true')])
"""
NEVER_ADDED = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    node = Node(package='my_pkg', executable='tracker')
    return LaunchDescription([])
"""
ACTION = "return LaunchDescription([Node(package='my_pkg', executable='talker', parameters=[config])])"
MORE = """\
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration
from nav2_common.launch import ReplaceString
"""
INCLUDES = """\
return LaunchDescription([
        IncludeLaunchDescription(AnyLaunchDescriptionSource(source), launch_arguments={'map': config}.items())])"""
CONDITION = lch014.BAD_CONDITION.replace("«", "").replace("»", "")
COMPARED = CONDITION.replace("IfCondition(not quiet)", "None").replace("'up'", "'up' if quiet == 'true' else 'on'")
LOG = "LogInfo(msg='up', condition=IfCondition(not quiet))"
NEVER_VISITED = CONDITION.replace(f"        {LOG},\n", "").replace(
    "    return", "    log = LogInfo(msg='up', condition=quiet)\n    return"
)
XACRO = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">\n  {}\n</robot>\n'
JOINT = '<joint name="a" type="revolute"><parent link="b"/><child link="c"/></joint>'
MESH = '<mesh filename="package://my_pkg/meshes/base.stl"/>'


def started(text: str, name: str) -> Example:
    return Example(bad={**lch002.FILES, "launch/a.launch.xml": None, f"launch/{name}": text}, good={})


def named(python: str) -> Example:
    text = python.replace("«", "").replace("»", "")
    return Example(bad={**lch003.NODE, "launch/robot.launch.py": text}, good={})


def robot(body: str) -> Example:
    install = "install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\nament_package"
    files = {"CMakeLists.txt": CMAKE.replace("ament_package", install), "urdf/robot.urdf.xacro": XACRO.format(body)}
    files["launch/show.xml"] = "<launch><let name='model' value='urdf/robot.urdf.xacro'/></launch>\n"
    return Example(bad=files, good={}, on="ament_cmake")


def called(text: str) -> Example:
    return Example(bad={"package.xml": manifest(lch014.NEEDED), "launch/a.launch.py": text}, good={})


HELPERS = """\
from launch import LaunchDescription
from launch.actions import OpaqueFunction


def load(path):
    return other(path)


def load_all(path=None):
    return [load(path)]


def generate_launch_description():
    return LaunchDescription([])
"""
UNREACHED = HELPERS
UNREACHED_TWICE = HELPERS.replace("Description([])", "Description([other])")
REACHED = HELPERS.replace("Description([])", "Description(load_all())")
BY_NAME = HELPERS.replace("Description([])", "Description([OpaqueFunction(function=load)])")
OTHER_WAYS = """\
from launch import LaunchDescription


def default(path=first):
    return None


@third
def registered():
    return second


class Loader:
    def load(self):
        return by_method()


def by_method():
    return fourth


def outer():
    def inner():
        return fifth

    return inner


def by_attribute():
    return sixth


def generate_launch_description():
    return LaunchDescription([Loader.by_attribute()])
"""

CASES = {
    "LCH002": (started(OFF, "b.launch.xml"), started(NEVER_ADDED, "b.launch.py")),
    "LCH003": (
        named(
            lch003.PYTHON.replace("    config = «", "    node = Node(package='my_pkg', executable='x', parameters=[")
            .replace("yaml')»", "yaml')])")
            .replace(ACTION, "return LaunchDescription([])")
        ),
        named(lch003.PYTHON.replace("robot_params.yaml", "robot.rviz")),
        *(
            named(
                MORE
                + lch003.PYTHON.replace("    return", f"    config = {made}\n    return").replace(ACTION, action)
            )
            for made, action in (
                ("ReplaceString(source_file=config)", "return LaunchDescription([])"),
                ("ReplaceString(source_file=config)", ACTION),
                ("launch.replaced(open(config))", "return LaunchDescription([])"),
            )
        ),
        named(MORE + lch003.PYTHON.replace("[config]", "[LaunchConfiguration('a', default=config)]")),
        named(MORE + lch003.PYTHON.replace("[config]", "[LaunchConfiguration(config, default='b')]")),
        named(MORE + lch003.PYTHON.replace(ACTION, INCLUDES)),
    ),
    "LCH007": (called(LOST_EXPRESSION),),
    "LCH013": (
        called(
            "from launch import LaunchDescription\n\n\ndef generate_launch_description():\n    names = []\n"
            "    if names:\n        names.append(other)\n    return LaunchDescription([])\n"
        ),
        *map(called, (UNREACHED, UNREACHED_TWICE, REACHED, BY_NAME, OTHER_WAYS)),
    ),
    "LCH011": tuple(
        Example(
            bad={**lch011.FILES, "launch/a.launch.xml": None, f"launch/{name}": text},
            good={},
            on="ament_cmake",
        )
        for name, text in (("b.launch.xml", OFF_CONTAINER), ("b.launch.py", LOST_CONTAINER))
    ),
    "LCH014": (
        called(COMPARED),
        called(NEVER_VISITED),
    ),
    "PLG002": (
        Example(
            bad={
                **plg002.PLUGIN,
                "plugins.xml": plg002.XML,
                "src/planner.cpp": plg002.SOURCE
                + "PLUGINLIB_EXPORT_CLASS(my_pkg::Base, nav2_core::GlobalPlanner)\nclass Planner : public Base {};\n",
            },
            good={},
            on="ament_cmake",
        ),
    ),
    "IDL011": (
        Example(
            bad={
                "CMakeLists.txt": CMAKE.replace(
                    "ament_package",
                    "find_package(rosidl_default_generators REQUIRED)\n"
                    'rosidl_generate_interfaces(my_pkg "srv/Start.srv")\nament_package',
                ),
                "srv/Start.srv": "---\n",
                "web/views.py": "from my_pkg.srv import Stop\n\nprint(Stop)\n",
            },
            good={},
            on="ament_cmake",
        ),
    ),
    "PRM002": (
        Example(bad={"config/robot.yaml": prm002.GOOD + "    depth: 5\n"}, good={}, on="config"),
        Example(bad={"config/robot.yaml": prm002.GOOD + "    depth: '5'\n"}, good={}, on="config"),
    ),
    "PRM003": (
        Example(
            bad={
                "launch/a.launch.xml": prm003.LAUNCH.replace('"sim_node"', '"$(var name)"').replace(
                    "<launch>\n", '<launch>\n  <arg name="name" default="sim_node"/>\n'
                ),
                "config/robot.yaml": prm003.GOOD.replace("sim_node", "simulation"),
            },
            good={},
            on="config",
        ),
    ),
    "PRM007": (
        Example(
            bad={"include/my_pkg/talker.hpp": prm007.NODE.replace("  }\n", '    get_parameter("verbos");\n  }\n')},
            good={},
            on="ament_cmake",
        ),
    ),
    "URD001": (
        robot(f'<xacro:if value="$(arg sim)">{JOINT}</xacro:if>'),
        robot(f'<xacro:macro name="arm" params="name">{JOINT}</xacro:macro>'),
        robot('<xacro:property name="width" value="${1 +"/>'),
        robot('<link name="a"><visual/></link>'),
    ),
    "URD002": (
        robot(f'<xacro:unless value="$(arg sim)">{MESH}</xacro:unless>'),
        robot('<xacro:property name="mesh" value="package://my_pkg/meshes/base.stl"/>'),
        robot(MESH + MESH.replace("base", "wheel")),
    ),
}  # fmt: skip
