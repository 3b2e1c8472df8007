"""Sentences about launch files that no example shows."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest
from rospkg_cli.rules.launch import lch008_undeclared_launch_argument as lch008
from rospkg_cli.rules.launch import lch009_unquoted_robot_description as lch009
from rospkg_cli.rules.launch import lch011_unknown_component as lch011
from rospkg_cli.rules.launch import lch013_undefined_launch_name as lch013
from rospkg_cli.rules.launch import lch014_invalid_launch_call as lch014

LAUNCH = "launch/a.launch.py"


def component(plugin: str, package: str = "my_pkg") -> Example:
    text = lch011.BAD.replace("«my_pkg::Taker»", plugin).replace('pkg="my_pkg"', f'pkg="{package}"')
    return Example(bad={**lch011.FILES, "launch/a.launch.xml": text}, good={}, on="ament_cmake")


def python(text: str) -> Example:
    return Example(bad={"package.xml": lch013.NEEDED, LAUNCH: text.replace("«", "").replace("»", "")}, good={})


IN_COMMENTS = "# def generate_launch_description():\n#     return None\n"
NOT_ADDED = lch008.BAD_PYTHON.replace("import LogInfo", "import DeclareLaunchArgument, LogInfo").replace(
    "    return", "    rate = DeclareLaunchArgument('rate')\n    return"
)

WHERE = "get_package_share_directory('my_pkg') + 'config/a.yaml'"
NO_SLASH = f"""\
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='my_pkg', executable='talker', parameters=[{WHERE}])])
"""


GIVEN = """\
from launch import LaunchDescription
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.actions import Node
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    there = PathJoinSubstitution([FindPackageShare('my_pkg'), 'config', 'a.yaml'])
    missing = PathJoinSubstitution([FindPackageShare('my_pkg'), 'config', 'b.yaml'])
    return LaunchDescription([Node(package='my_pkg', executable='talker', parameters=[{}])])
"""
GIVEN_FILES = (
    "there, missing",
    "missing, {'rate': 2.0}",
    "missing, missing",
    "missing, LaunchConfiguration('more')",
    "there]), Node(package='my_pkg', executable='listener', parameters=[missing",
)


def with_file(text: str) -> Example:
    """A package with one parameter file."""
    return Example(bad={"package.xml": lch013.NEEDED, "config/a.yaml": "a: 1\n", LAUNCH: text}, good={})


def elsewhere(package: str, plugin: str) -> Example:
    """Two packages: the launch file of one asks for a component that is in the other, or in none."""
    other = {f"other/{path}": text for path, text in lch011.FILES.items() if not path.startswith("launch")}
    text = other["other/CMakeLists.txt"]
    other["other/CMakeLists.txt"] = text.replace("install(DIRECTORY launch", "install(FILES LICENSE")
    other["other/LICENSE"] = "Apache License\n"
    needed = manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake", "my_user")
    cmake = CMAKE.replace("my_pkg", "my_user").replace(
        "ament_package", "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package"
    )
    text = lch011.BAD.replace("«my_pkg::Taker»", plugin).replace('pkg="my_pkg"', f'pkg="{package}"')
    user = {"user/package.xml": needed, "user/CMakeLists.txt": cmake, "user/launch/a.launch.xml": text}
    return Example(bad={**other, **user}, good={}, on="")


NOTE = "<!-- as follows: a -->\n"
MAIN = (
    '{}<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">\n'
    '  <xacro:include filename="part.xacro"/>\n</robot>\n'
)
PART = '<?xml version="1.0"?>\n{}<robot name="part">\n  {}<link name="base"/>\n</robot>\n'


HALF_KNOWN = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.substitutions import LaunchConfiguration
from somewhere import more


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('{}', default_value='a'),
        LogInfo(msg=LaunchConfiguration('{}')),
        *more({}),
    ])
"""
SLIPS = (
    ("robot_name", "robot_nmae", ""),
    ("robot_name", "robot_nmae", "'robot_name'"),
    ("robot_name", "robot_nmae", "'robot_nmae'"),
    ("robot_name", "robto_nmae", ""),
    ("robot_1", "robot_2", ""),
    ("name", "nmae", ""),
    ("names", "naems", ""),
)
WRONG_MODULE = """\
from launch import LaunchDescription
from {} import {}


def generate_launch_description():
    return LaunchDescription([])
"""
MODULES = (
    ("launch.action", "DeclareLaunchArgument, LogInfo"),
    ("launch_ros.acton", "Node"),
    ("launch.action", "Action"),
    ("launch_xml.action", "Node"),
    ("launch.plugins", "LogInfo"),
    ("launch.actions.log_info", "LogInfo"),
)


CASES = {
    "LCH003": (
        with_file(NO_SLASH),
        *(with_file(GIVEN.format(each)) for each in GIVEN_FILES),
    ),
    "LCH001": (python(IN_COMMENTS),),
    "LCH008": (
        python(NOT_ADDED),
        *(python(HALF_KNOWN.format(declared, used, more)) for declared, used, more in SLIPS),
        Example(
            bad={
                "package.xml": manifest(lch009.NEEDED),
                LAUNCH: HALF_KNOWN.format("robot_name", "robot_nmae", ""),
                "launch/b.launch.xml": '<launch>\n  <arg name="robot_nmae" default="a"/>\n</launch>\n',
            },
            good={},
        ),
    ),
    "LCH009": (
        *(
            Example(
                bad={
                    "package.xml": manifest(lch009.NEEDED),
                    "urdf/robot.urdf.xacro": MAIN.format(main),
                    "urdf/part.xacro": PART.format(head, inside),
                    LAUNCH: lch009.BAD.replace("«", "").replace("»", ""),
                },
                good={},
            )
            for main, head, inside in (("", NOTE, ""), ("", "", NOTE), (NOTE, "", ""))
        ),
        Example(
            bad={
                "package.xml": manifest(lch009.NEEDED),
                "urdf/robot.urdf.xacro": '<robot name="robot"/>\n',
                LAUNCH: lch009.BAD.replace("«", "").replace("»", ""),
            },
            good={},
        ),
    ),
    "LCH011": (
        component("other::Camera"),
        component("my_pkg::Listener"),
        elsewhere("my_user", "my_pkg::Talker"),
    ),
    "LCH013": (
        python(lch013.BAD.replace("«DeclareLaunchArgument»('rate', default_value='10')", "LogInof(msg='x')")),
        python(lch013.BAD.replace("«DeclareLaunchArgument»('rate', default_value='10')", "something_else")),
        python(
            "import os\n"
            + lch013.BAD.replace("«DeclareLaunchArgument»('rate', default_value='10')", "os.path.joint('a')")
        ),
        *(python(WRONG_MODULE.format(module, name)) for module, name in MODULES),
    ),
    "LCH014": (python(lch014.BAD.replace("package='tf2_ros', executable=", "").replace("arguments=", "")),),
}
