"""Sentences about dependencies, setup.py, interfaces, parameters and robots that no example shows."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, INTERFACES_CMAKE, Example, manifest, scripts, setup_py
from rospkg_cli.rules.depends import dep108_undeclared_interface_package as dep108
from rospkg_cli.rules.interfaces import idl007_missing_interface_dependency as idl007
from rospkg_cli.rules.params import prm008_missing_parameter as prm008
from rospkg_cli.rules.setup import set203_manifest_not_installed as set203
from rospkg_cli.rules.setup import set206_data_folder_not_installed as set206

NODE = "find_package(rclcpp REQUIRED)\nadd_executable(node src/node.cpp)\n"


def python(depends: str, **files: str) -> Example:
    named = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in files.items()}
    return Example(bad={"package.xml": manifest(depends), **named}, good={})


def interfaces(text: str, depends: str = "", cmake: str = dep108.CMAKE_MSG) -> Example:
    body = dep108.TOOLS + depends + dep108.RUNTIME + dep108.GROUP
    files = {"CMakeLists.txt": cmake, "msg/Pose.msg": text, "package.xml": manifest(body, "ament_cmake")}
    return Example(bad=files, good={}, on="ament_cmake")


def cmake(lines: str, depends: str, **files: str) -> Example:
    named = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in files.items()}
    text = CMAKE.replace("ament_package", lines + "ament_package")
    return Example(
        bad={"CMakeLists.txt": text, "package.xml": manifest(depends, "ament_cmake"), **named},
        good={},
        on="ament_cmake",
    )


def installed(entries: str) -> Example:
    """A Python package whose data_files have more entries."""
    text = setup_py().replace("['package.xml']),", f"['package.xml']),\n        {entries},")
    return python("", setup_DOT_py=text, config__a_DOT_yaml="a: 1\n")


SHARE = "share/my_pkg/config"
SHORT = INTERFACES_CMAKE.replace('\n  "', ' "').replace('"\n)', '")')
LATER = INTERFACES_CMAKE.replace("rosidl_generate_", "set(A msg)\nrosidl_generate_")
"""Something is between what is looked for and the call that needs it."""
YAML = "talker:\n  ros__parameters:\n    a: &x 1\n"
ROBOT = """\
<robot name="robot">
  <link name="base">
    <visual>
      <geometry><mesh filename="package://my_pkg/meshes/base.stl"/></geometry>
    </visual>
  </link>
</robot>
"""
LAUNCH = """\
from launch import LaunchDescription


def generate_launch_description():
    return LaunchDescription()
"""
GENERATOR = """\
from writer import LaunchFile, Node, Package


class Generator:
    def __init__(self):
        self.joy = {}
        {}

    def write(self):
        return {}
"""
JOY, ADDED, AGAIN = "Package('joy')", "pass", "self.joy = None"
GENERATED = (
    (JOY, ADDED, "LaunchFile('a', package=self.joy)"),
    (JOY, AGAIN, "LaunchFile('a', package=self.joy)"),
    ("'joy'", ADDED, "Node(package=self.joy, executable='joy_node')"),
    ("'joy'", ADDED, "LaunchFile('a', package=self.joy)"),
    ("None", ADDED, "LaunchFile('a', package=Package('joy'))"),
    ("None", ADDED, "LaunchFile('a', package=Package('joy', 'humble'))"),
    ("None", ADDED, "LaunchFile('a', package=Folder('joy'))"),
    ("None", ADDED, "LaunchFile('a', package=Package(joy))"),
)
IN_FUNCTION = (
    "from writer import LaunchFile\n\n\ndef node():\n    return LaunchFile.Node(package='turtlesim', executable='a')\n"
)
NODE_IN_TEST = """\
from launch_ros.actions import Node as LaunchNode


class Helper:
    def start(self):
        return LaunchNode(package="turtlesim", executable="turtlesim_node")
"""
DESCRIBED = "from launch_ros.actions import Node\n\nN = Node(package='turtlesim', executable='a')\n"

TESTED = setup_py("tests_require=['{}'],").replace("    extras_require={'test': ['pytest']},\n", "")
GO = interfaces("float32 a\n", cmake=dep108.CMAKE_MSG.replace("msg/Pose.msg", "action/Go.action"))
GOES = Example(bad={**GO.bad, "action/Go.action": "int32 a\n---\n---\n"}, good={}, on="ament_cmake")

CASES = {
    "DEP101": (
        python("", setup_DOT_py="import numpy\n" + setup_py()),
        python("  <exec_depend>yaml</exec_depend>\n", my_pkg__a_DOT_py="import yaml\n"),
        python("  <exec_depend>sensor_msgs</exec_depend>\n", my_pkg__a_DOT_py="import std_msgs.msg\n"),
    ),
    "DEP001": (
        *(cmake("", lines) for lines in (
            "  <exec_depend>pyserial</exec_depend>\n",
            "  <build_depend>pyserial</build_depend>\n  <exec_depend>pyserial</exec_depend>\n",
        )),
        cmake("find_package(OpenCV REQUIRED)\n", "  <exec_depend>opencv</exec_depend>\n"),
        *(cmake(f"find_package(ament_cmake_auto REQUIRED)\n{lines}\n", "  <depend>OpenCV</depend>\n")
        for lines in ("", "ament_auto_find_build_dependencies()",
                      "find_package(OpenCV REQUIRED)\nament_auto_find_build_dependencies()")),
        *(Example(on="", good={}, bad={
            "a/package.xml": manifest("  <depend>nav2_utils</depend>\n", "ament_cmake"),
            "a/CMakeLists.txt": "cmake_minimum_required(VERSION 3.8)\nproject(my_pkg)\n",
            f"{folder}/CMakeLists.txt": lines,
        }) for folder, lines in (
            ("libs/nav2_utils", "cmake_minimum_required(VERSION 3.8)\nproject(nav2_utils CXX)\n"),
            ("libs/nav2_utils", "# project(nav2_utils)\nadd_library(nav2_utils a.cpp)\n"),
            ("a/nav2_utils", "project(nav2_utils)\n"),
        )),
    ),
    "DEP102": (
        python("  <exec_depend>sensor_msgs</exec_depend>\n", test__test_a_DOT_py="import std_msgs.msg\n"),
        *(
            python(f"  <test_depend>{name}</test_depend>\n", test__test_a_DOT_py="import launch\nimport launch_ros\n")
            for name in ("ros_testing", "launch_testing", "who_knows")
        ),
        *(
            python("", test__test_a_DOT_py="import cv2\n", setup_DOT_py=TESTED.format(asks), setup_DOT_cfg=config)
            for asks, config in (("", ""), ("pytest", ""), ("", "[options]\ntests_require = pytest\n"))
        ),
    ),
    "DEP103": (
        python("", launch__a_DOT_launch_DOT_py=LAUNCH),
        python("", my_pkg__a_DOT_py=DESCRIBED),
        python("", test__test_a_DOT_py=NODE_IN_TEST),
        python("", test__test_a_DOT_py=NODE_IN_TEST.replace("turtlesim", "made_up_by_us")),
        python("  <exec_depend>turtlesim</exec_depend>\n", test__test_a_DOT_py=NODE_IN_TEST),
        python("", test__test_a_DOT_py=NODE_IN_TEST, my_pkg__a_DOT_py=NODE_IN_TEST),
        python("", my_pkg__launch__a_DOT_py=IN_FUNCTION),
        *(python("", my_pkg__a_DOT_py=GENERATOR.format(first, more, call)) for first, more, call in GENERATED),
        python("", my_pkg__launch__a_DOT_py=IN_FUNCTION + "\n\ndef generate_launch_description():\n    return []\n"),
    ),
    "DEP104": (
        cmake("find_package(std_msgs REQUIRED)\n", "  <depend>sensor_msgs</depend>\n"),
        *(
            cmake(
                f"find_package({found} REQUIRED)\nadd_executable(node src/node.cpp)\n",
                "  <depend>sensor_msgs</depend>\n",
                src__node_DOT_cpp="#include <geometry_msgs/msg/pose.hpp>\n#include <std_msgs/msg/string.hpp>\n",
            )
            for found in ("std_msgs", "nav2_msgs")
        ),
        cmake("find_package(ament_cmake_python REQUIRED)\n", ""),
    ),
    "DEP108": (
        interfaces("geometry_msgs/Pose2D pose\n", cmake=dep108.CMAKE_MSG.replace(" DEPENDENCIES geometry_msgs", "")),
        interfaces("std_msgs/Header header\n", cmake=dep108.CMAKE_MSG),
        interfaces("geometry_msgs/Pose2D pose\n", "  <depend>sensor_msgs</depend>\n"),
        interfaces("geometry_mgs/Pose2D pose\n", "  <depend>geometry_msgs</depend>\n", cmake=dep108.CMAKE_MSG),
        interfaces("builtin_interfaces/Time at\nbuiltin_interfaces/Time to\n"),
        GOES,
        interfaces("".join(f"geometry_msgs/Pose2D p{number}\n" for number in range(6))),
    ),
    "DEP202": (
        cmake(NODE + "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n",
              "  <depend>rclcpp</depend>\n  <depend>nav2_bringup</depend>\n", src__node_DOT_cpp="int main() {}\n",
              launch__a_DOT_launch_DOT_xml="<launch>\n  <node pkg='nav2_bringup' exec='x'/>\n</launch>\n"),
    ),
    "DEP204": (
        cmake("if(BUILD_TESTING)\n  find_package(ament_cmake_gtest REQUIRED)\n  find_package(std_msgs REQUIRED)\n"
              "  ament_add_gtest(test_a test/test_a.cpp)\nendif()\n",
              "  <depend>std_msgs</depend>\n  <test_depend>ament_cmake_gtest</test_depend>\n",
              test__test_a_DOT_cpp="#include <std_msgs/msg/string.hpp>\nstd_msgs::msg::String made();\n"),
    ),
    "IDL004": (
        interfaces("my_pkg/SetMode mode\n"),
        Example(bad={"msg/Status.msg": "SetMode mode\n"}, good={}, on="interfaces"),
    ),
    "IDL007": (
        Example(bad={**idl007.FILES, "CMakeLists.txt": LATER}, good={}, on="interfaces"),
        Example(bad={**idl007.FILES, "CMakeLists.txt": SHORT}, good={}, on="interfaces"),
    ),
    "PRM004": tuple(
        Example(bad={"config/robot.yaml": YAML + lines}, good={}, on="config")
        for lines in (
            "    b: [*x]\n", "    b:\n    - 1\n    -\n", "    b: [[1]]\n",
            "    b: {1.0, 1.0}\n", "    b: {1.0, x}\n",
            "    b: [[1], [2]]\n", "    b: [[1], 2]\n", "    b: [1, {c: 2}]\n")
    ),
    "PRM008": tuple(
        Example(
            bad={
                **prm008.FILES,
                "src/talker.cpp": prm008.NODE.replace(
                    '    declare_parameter<double>("rate");\n',
                    "".join(f'    declare_parameter<double>("p{number:02}");\n' for number in range(count)),
                ),
                "launch/talker.launch.xml": '<launch>\n  <node pkg="my_pkg" exec="talker"/>\n</launch>\n',
            },
            good={},
            on="ament_cmake",
        )
        for count in (1, 19, 20, 22)
    ),
    "WSP001": (
        Example(
            on="",
            bad={
                "ros1/my_pkg/package.xml": manifest("  <buildtool_depend>catkin</buildtool_depend>\n", "catkin"),
                "ros2/my_pkg/package.xml": manifest("", "ament_cmake"),
                "ros2/my_pkg/CMakeLists.txt": CMAKE,
            },
            good={},
        ),
    ),
    "SET101": (
        python("", setup_DOT_py=setup_py(scripts("talker = speech.talker:main")).replace(
            "packages=find_packages(exclude=['test'])", "packages=['my_pkg', 'speech']")),
        python("", setup_DOT_py="from ament_index_python import get_package_prefix\nA = get_package_prefix('a')\n"
               + setup_py(scripts("talker = my_pkg.talker:main"))),
    ),
    "SET203": (python("", setup_DOT_py=set203.BAD.replace("«", "").replace("»", "").replace("'", '"')),),
    "SET205": (installed(f"('{SHARE}', ['config/*.yaml'])"), installed(f"('{SHARE}', ['config'])")),
    "SET209": (installed("('share/my_pkg/xml', ['package.xml'])"),),
    "SET206": (
        python("", setup_DOT_py=setup_py(), launch__a_DOT_launch_DOT_xml="<launch>\n</launch>\n"),
        Example(bad={**set206.FILES, "setup.py": "from glob import glob\n" + setup_py()}, good={}),
        Example(bad={**set206.FILES, "setup.py": "import glob\n" + setup_py()}, good={}),
    ),
    "SET301": (python("", my_pkg__speech__words_DOT_py="A = 1\n"),),
    "SET401": (python("", setup_DOT_py=setup_py().replace("'my_pkg'", "'your_pkg'")),),
    "URD002": (
        Example(bad={"urdf/robot.urdf": ROBOT, "meshes/bas.stl": "solid base\n"}, good={}, on="ament_cmake"),
    ),
}  # fmt: skip
