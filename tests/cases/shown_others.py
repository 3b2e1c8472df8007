"""Sentences and silences of the rules for dependencies, plugins, setup.py and what CMake installs."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest
from rospkg_cli.rules.plugins import plg002_unexported_plugin as plg002

from .launch import elsewhere
from .shown_cmake import HOME, PYTHON, package
from .shown_interfaces import BOTH, listed, typed

TESTS = "  <test_depend>launch_testing</test_depend>\n  <test_depend>{}</test_depend>\n"
JOY = '<launch>\n  <node pkg="joy" exec="joy_node"/>\n</launch>\n'
TURTLES = """\
<launch>
  <node pkg="turtlesim" exec="turtlesim_node"/>
  <node pkg="demo_nodes_cpp" exec="talker"/>
</launch>
"""
LOADS = """\
<launch>
  <node_container pkg="rclcpp_components" exec="component_container" name="c" namespace="">
    <composable_node pkg="image_proc" plugin="image_proc::RectifyNode" name="r"/>
  </node_container>
  <executable cmd="rviz2 -d a.rviz"/>
</launch>
"""
LOOKS = """\
<launch>
  <arg name="x" default="$(find-pkg-share joy)/$(find-exec xacro)"/>
  <include file="$(find-pkg-share who_knows)/a.xml"/>
  <let name="y" value="$(command 'xacro a')"/>
</launch>
"""
SETUP = """\
from setuptools import setup

setup(
    name='my_pkg',
    packages=['my_pkg'],
    data_files=[
        ('share/my_pkg', ['package.xml']),
    ],
)
"""
TESTED = "if(BUILD_TESTING)\n  add_launch_test(launch/a.launch.xml)\nendif()"
FOLDER = {"config/a.yaml": "a: 1\n", "urdf/a.urdf": "<robot/>\n"}
SHARE = "DESTINATION share/${PROJECT_NAME}"
INSTALLED = "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})"
INCLUDES = "".join(
    f"#include <{each}>\n"
    for each in (
        "vector", "my_pkg/a.hpp", "rclcpp/rclcpp.hpp", "std_msgs/msg/string.hpp", "std_msgs/msg/header.hpp",
        "Eigen/Core",
        "tf2_ros/buffer.h", "sensor_msgs/msg/image.hpp", "geometry_msgs/msg/pose.hpp", "who/knows.hpp",
        "opencv2/core.hpp",
        "nav_msgs/msg/path.hpp", "boost/optional.hpp", "yaml-cpp/yaml.h",
        "ament_index_cpp/get_package_share_directory.hpp",
    )
)  # fmt: skip
GUARDED = """\
#if __has_include(<std_msgs/msg/string.hpp>)
#include <std_msgs/msg/string.hpp>
#endif
#ifdef X
#include <nav_msgs/msg/path.hpp>
#endif
"""
TALKER = f"add_executable(talker src/a.cpp)\ninstall(TARGETS talker {HOME})"
IMPORTS = """\
import numpy, cv2, yaml, os, my_pkg.words, who_knows
from sensor_msgs.msg import Image
from std_msgs import msg
import rclpy.node
from .words import A
try:
    import nav_msgs.msg
except ImportError:
    nav_msgs = None
if TYPE_CHECKING:
    import geometry_msgs.msg
import tf2_ros, launch, launch_ros.actions, ament_index_python
"""


def python(depends: str, **files: str) -> Example:
    named = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in files.items()}
    return Example(bad={"package.xml": manifest(depends), **named}, good={})


def declared(*names: str, tag: str = "depend") -> str:
    return "".join(f"  <{tag}>{name}</{tag}>\n" for name in names)


def built(*lines: str, files: dict[str, str], body: str = "") -> Example:
    found = package(*lines, files=files)
    return Example(bad={**found.bad, "package.xml": manifest(body, "ament_cmake")}, good={}, on="ament_cmake")


FINDS = (
    "find_package(std_msgs REQUIRED)",
    "find_package(nav_msgs)",
    "find_package(tf2_ros QUIET)",
    "find_package(Eigen3 REQUIRED)",
    "find_package(OpenCV REQUIRED)",
    "find_package(who_knows REQUIRED)",
    "find_package(Threads REQUIRED)",
    "find_package(${NAME} REQUIRED)",
    "find_package(ament_cmake_python REQUIRED)",
    "find_package(Boost REQUIRED COMPONENTS x)",
    "if(UNKNOWN)\n  find_package(joy REQUIRED)\nendif()",
    "if(BUILD_TESTING)\n  find_package(ament_cmake_gtest REQUIRED)\nendif()",
    "find_package(yaml-cpp REQUIRED)",
    "find_package(octomap REQUIRED)",
    "find_package(my_pkg REQUIRED)",
    "find_package(std_msgs REQUIRED)",
)
USES = (
    "target_link_libraries(talker nav_msgs::x tf2_ros::tf2_ros)",
    "ament_target_dependencies(talker sensor_msgs)",
    "target_link_libraries(talker geometry_msgs::geometry_msgs ${std_msgs_TARGETS} m ${UNKNOWN})",
)
PLUGINS = {**plg002.PLUGIN, "plugins.xml": plg002.XML, "src/planner.cpp": plg002.SOURCE}

CASES = {
    "CMK101": (
        *(package(f"install(DIRECTORY {each})", files=FOLDER)
          for each in (f"urdf {SHARE}", f"urdf/ {SHARE}", f"urdf {SHARE} PATTERN x EXCLUDE",
              f"urdf {SHARE} FILES_MATCHING PATTERN *",
                       f"urdf {SHARE} USE_SOURCE_PERMISSIONS", f"urdf {SHARE}/more", f"urdf\n  {SHARE}")),
        Example(bad={**FOLDER, "CMakeLists.txt": CMAKE + "message(x)\n"}, good={}, on="ament_cmake"),
        Example(bad={**FOLDER, "CMakeLists.txt": CMAKE.replace("ament_package()",
                "ament_auto_package()\nmessage(x)")}, good={},
                on="ament_cmake"),
        Example(bad={**FOLDER, "CMakeLists.txt": CMAKE.replace("ament_package()",
                "ament_auto_package(INSTALL_TO_SHARE urdf)")},
                good={}, on="ament_cmake"),
        package("if(UNKNOWN)\n  install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\nendif()", files=FOLDER),
        package("generate_parameter_library(a config/a.yaml)", files=FOLDER),
        *(
            package(f"install(DIRECTORY launch {SHARE})", files={
                "config/a.yaml": "a: 1\n",
                "launch/a.launch": f"<launch><rosparam file='$({find} my_pkg)/config/a.yaml'/></launch>\n",
            })
            for find in ("find", "find-pkg-share")
        ),
        package("", files={"launch/a.launch.xml": '<launch><node pkg="joy" type="joy_node" name="j"/></launch>\n'}),
        package("", files={"launch/a.launch.xml": '<launch><node pkg="joy" exec="joy_node" name="j"/></launch>\n'}),
        package("configure_file(config/a.yaml b.yaml)", files=FOLDER),
    ),
    "CMK109": (
        Example(bad={**PYTHON, "CMakeLists.txt": CMAKE.replace(
            "ament_package()", f"install(PROGRAMS scripts/d.py {HOME})\nament_package()\nmessage(x)")},
                good={}, on="ament_cmake"),
    ),
    "DEP101": (
        python("", my_pkg__a_DOT_py=IMPORTS, my_pkg__words_DOT_py="import sensor_msgs.msg\n" * 5),
        python(declared("sensor_msgs", "rclpy", "python3-numpy"), my_pkg__a_DOT_py=IMPORTS),
        python("  <author>std_msgs</author>\n", my_pkg__a_DOT_py="import std_msgs.msg\n"),
        python("  <exec_dependd>std_msgs</exec_dependd>\n", my_pkg__a_DOT_py="import std_msgs.msg\n"),
        python("", setup_DOT_py="import cv2\nfrom setuptools import setup\nimport rclpy\n\nsetup(name='my_pkg')\n"),
    ),
    "CMK103": (
        package(TALKER.partition("\n")[0], "set_target_properties(talkre PROPERTIES CXX_STANDARD 17)",
                files={"src/a.cpp": "int main() {}\n"}),
        package(TALKER.replace("TARGETS talker", "TARGETS talkre"), files={"src/a.cpp": "int main() {}\n"}),
    ),
    "DEP102": (
        python("", test__test_a_DOT_py=IMPORTS, tests__b_DOT_py="import pytest\n"),
        python(declared("ament_lint_auto", "launch_testing_ros", tag="test_depend"),
               test__a_DOT_py=IMPORTS + "import launch_testing\n"),
    ),
    "DEP103": (
        built(TESTED, files={"launch/a.launch.xml": JOY}),
        built(TESTED, INSTALLED, files={"launch/a.launch.xml": JOY}),
        built(INSTALLED, files={"launch/a.launch.xml": JOY, "launch/b.launch.xml": JOY.replace("joy_node", "other")}),
        built(INSTALLED, files={"launch/example.launch.xml": JOY, "launch/demo.launch.xml": JOY.replace("joy", "rviz2"),
              "launch/a_test.launch.xml": JOY.replace("joy", "twist_mux"), "launch/b.launch.xml": TURTLES,
              "launch/demos/c.launch.xml": JOY.replace("joy", "teleop_twist_keyboard")}),
        built(INSTALLED, files={"launch/a.launch.xml": LOADS}),
        built(INSTALLED, files={"launch/a.launch.xml": JOY.replace("joy", "jooy")}),
        built(INSTALLED, files={"launch/a.launch.xml": LOOKS}),
    ),
    "DEP104": (
        built(*FINDS, TALKER, *USES, files={"src/a.cpp": "int main() {}\n"}),
        built(*FINDS, TALKER, *USES, files={"src/a.cpp": "int main() {}\n"}, body=declared("sensor_msgs", "eigen",
              "liboctomap-dev")),
        built(*FINDS[:2], files={}, body=declared("who_knows")),
    ),
    "DEP105": (
        built(TALKER, files={"src/a.cpp": INCLUDES, "include/my_pkg/a.hpp": ""}),
        built(TALKER, files={"src/a.cpp": INCLUDES, "src/b.cpp": INCLUDES}, body=declared("sensor_msgs", "who_knows")),
        built(TALKER, files={"src/a.cpp": GUARDED, "src/unused.cpp": INCLUDES}),
        *(built(TALKER, each, files={"src/a.cpp": text, "include/my_pkg/a.hpp": INCLUDES})
          for text in ("int main() {}\n", '#include "my_pkg/a.hpp"\n')
          for each in ("", "install(DIRECTORY include/ DESTINATION include)")),
        built("if(BUILD_TESTING)\n  add_executable(t test/a.cpp)\nendif()", files={"test/a.cpp": INCLUDES}),
        built("find_package(yaml_cpp_vendor REQUIRED)", TALKER, files={"src/a.cpp": "#include <yaml-cpp/yaml.h>\n"}),
        *(built(*lines, TALKER, files={"src/a.cpp": "#include <diagnostic_msgs/msg/key_value.hpp>\n"}) for lines in (
              ("find_package(diagnostic_updater REQUIRED)",), ("find_package(diagnostic_updater)",),
              ("if(BUILD_TESTING)", "find_package(diagnostic_updater REQUIRED)", "endif()"),
              ("if(WITH_TALKER)", "find_package(diagnostic_updater REQUIRED)", "endif()"))),
        built("if(BUILD_TESTING)\n  find_package(diagnostic_updater REQUIRED)\n  add_executable(t test/a.cpp)\nendif()",
              files={"test/a.cpp": "#include <diagnostic_msgs/msg/key_value.hpp>\n"}),
        built(f"if(WITH_TALKER)\n{TALKER}\nendif()", files={"src/a.cpp": "#include <nav_msgs/msg/path.hpp>\n"}),
    ),
    "DEP106": (
        *(Example(bad={"urdf/a.urdf": '<robot name="a"><link name="b"><visual><geometry><mesh filename="package://joy/a.stl"/>'
                       "</geometry></visual></link></robot>\n", **more}, good={}, on=on)
          for on, more in (("ament_python", {}), ("ament_cmake", {}), ("ament_python",
              {"setup.py": "from x import *\nsetup()\n"}))),
    ),
    "DEP107": (
        built(TALKER, *USES, files={"src/a.cpp": INCLUDES}, body=declared("std_msgs", "nav_msgs", "geometry_msgs",
              "tf2_ros")),
        built(TALKER, *USES, files={"src/a.cpp": INCLUDES}, body=declared("sensor_msgs", "nav_msgs",
              tag="exec_depend")),
        built("find_package(ament_cmake_auto REQUIRED)", "ament_auto_find_build_dependencies()", TALKER, *USES,
              files={"src/a.cpp": INCLUDES}, body=declared("std_msgs", "nav_msgs")),
        built("find_package(sensor_msgs REQUIRED)", TALKER, *USES, files={"src/a.cpp": INCLUDES},
              body=declared("std_msgs", "nav_msgs", "sensor_msgs", "geometry_msgs")),
        built("if(BUILD_TESTING)", "add_executable(t test/a.cpp)", "target_link_libraries(t joy::joy)", "endif()",
              files={"test/a.cpp": INCLUDES}, body=declared("std_msgs", "joy", tag="test_depend")),
    ),
    "DEP202": (
        typed("float32", depends=("joy", "std_msgs", "rosidl_default_runtime")),
        built(INSTALLED, files={"test/a.py": "import launch_testing\n"}, body=TESTS.format("launch_testing_ros")),
        built(INSTALLED, files={"test/a.py": "import launch_testing\n"}, body=TESTS.format("launch_ros")),
        built(INSTALLED, files={"test/a.py": "import os\n"}, body=TESTS.format("launch_testing_ament_cmake")),
        built(TALKER, files={"src/a.cpp": "int main() {}\n"}, body=declared("std_msgs", "rclcpp", "python3-numpy",
              "joy_vendor")),
        python(declared("std_msgs", "python3-numpy", "rclpy", tag="exec_depend") + declared("nav_msgs"),
               my_pkg__a_DOT_py="import rclpy\n"),
    ),
    "IDL004": (
        typed("Go", cmake=listed(*BOTH, "action/Go.action"), action__Go_DOT_action="---\n---\n"),
        typed("SetMode", "Go", "std_msgs/SetMode"),
    ),
    "LCH011": (elsewhere("no_such_pkg", "my_pkg::Talker"), elsewhere("rclcpp", "my_pkg::Talker")),
    "PLG002": tuple(
        Example(bad={path: text.replace(old, new) for path, text in PLUGINS.items()}, good={}, on="ament_cmake")
        for old, new in (("", ""), ('type="my_pkg::Planner"', 'type="my_pkg::Plannr"'), ('name="my_pkg/Planner" ', ""),
                         ("pluginlib_export_plugin_description_file", "message"), ("PLUGINLIB_EXPORT_CLASS", "NOTHING"),
                         ("add_library(my_planner SHARED", "add_library(my_planner STATIC"))
    ),
    "SET206": tuple(
        python("", setup_DOT_py=SETUP, **dict.fromkeys(names, "a: 1\n"))
        for names in (("launch__a_DOT_launch_DOT_py",), ("launch__a_DOT_launch_DOT_py", "launch__b_DOT_launch_DOT_xml"),
                      ("launch__a_DOT_launch_DOT_py", "launch__rviz_DOT_yaml"), ("config__a_DOT_yaml",
                          "config__b_DOT_yaml"),
                      ("config__a_DOT_yaml", "config__b_DOT_txt"), ("config__a_DOT_yaml", "config__deep__b_DOT_yaml"),
                      ("rviz__a_DOT_rviz",), ("maps__a_DOT_pgm", "maps__a_DOT_yaml"))
    ),
}  # fmt: skip
