"""What `new` writes, with one fault seeded at a time: `lint` names each of them, and nothing else beside it.

The faults are those on which the linters that were there before us were compared: the best of them named 18 of the 62.
"""

from __future__ import annotations

import pytest
from planned import plan, texts
from seeding import Files, before, both, drop, edit, line, put, swap

from rospkg_cli.testing import lint_files

LAUNCH = "launch/my_robot.launch.py"
XML, YAML = "launch/extra.launch.xml", "launch/more.launch.yaml"
SETUP, MANIFEST, PARAMS, CFG = "setup.py", "package.xml", "config/params.yaml", "setup.cfg"
NODE = "my_robot/talker.py"
URDF = """\
<robot name="my_robot">
  <link name="base_link"/>
  <link name="wheel"/>
  <joint name="axle" type="fixed"><parent link="base_link"/><child link="wheel"/></joint>
</robot>
"""
BESIDE = {
    XML: """\
<launch>
  <arg name="params" default="$(find-pkg-share my_robot)/config/params.yaml"/>
  <node pkg="my_robot" exec="talker" name="second">
    <param from="$(var params)"/>
  </node>
</launch>
""",
    YAML: """\
launch:
- node:
    pkg: my_robot
    exec: talker
    name: third
    param:
    - from: $(find-pkg-share my_robot)/config/params.yaml
""",
    "urdf/my_robot.urdf": URDF,
}


def sound() -> Files:
    """Return a package as `new` writes it, with more launch files, a robot description, and dependencies in use."""
    files = texts(plan("my_robot", nodes=("talker:publisher",), depends=("nav_msgs",))) | BESIDE
    share = "        ('share/' + package_name + '/config',"
    edit(files, SETUP, share, "        ('share/' + package_name + '/urdf', glob('urdf/*.urdf')),\n" + share)
    last = "  <exec_depend>launch_ros</exec_depend>\n"
    edit(
        files,
        MANIFEST,
        last,
        last + "".join(f"  <exec_depend>{n}</exec_depend>\n" for n in ("launch_xml", "launch_yaml")),
    )
    return files


IMPORT = "import rclpy\n"
SYNTAX = "def broken(:\n"
SETUP_FAULTS = {
    "entry point to a missing module": (swap(SETUP, "my_robot.talker:main", "my_robot.taker:main"), "SET101"),
    "entry point to a missing function": (swap(SETUP, "talker:main", "talker:run"), "SET102"),
    "a glob that matches nothing": (swap(SETUP, "config/*.yaml", "config/*.yml"), "SET204"),
    "launch files that are not installed": (line(SETUP, "launch.[pxy]"), "SET206"),
    "no marker": (drop("resource/my_robot"), "SET202"),
    "a marker that is not installed": (line(SETUP, "resource_index"), "SET201"),
    "package.xml is not installed": (swap(SETUP, "['package.xml']", "['README.md']"), "SET203"),
    "another name in setup.py": (swap(SETUP, "name=package_name", "name='my_robto'"), "SET401"),
    "another version in setup.py": (swap(SETUP, "0.1.0", "0.2.0"), "SET402"),
    "no setup.cfg": (drop(CFG), "SET001"),
    "setup.cfg without the place of scripts": (put(CFG, "[metadata]\nname = my_robot\n"), "SET002"),
    "setup.cfg with another package's place": (swap(CFG, "lib/my_robot", "lib/my_robto", 9), "SET002"),
    "setup.cfg with dashes": (swap(CFG, "script_dir", "script-dir"), "SET003"),
    "no __init__.py": (drop("my_robot/__init__.py"), "SET301"),
    "an entry point without =": (swap(SETUP, "talker = my", "talker my"), "SET103"),
    "setup.py that is no Python": (before(SETUP, "setup(", SYNTAX), "RPK001"),
    "another license in setup.py": (swap(SETUP, "'Apache-2.0'", "'MIT'"), "SET403"),
    "another maintainer in setup.py": (line(SETUP, "maintainer=", "    maintainer='Bob',\n"), "SET403"),
    "CMakeLists.txt beside setup.py": (put("CMakeLists.txt", "project(my_robot)\n"), "XML307"),
    "a file of data_files that is missing": (swap(SETUP, "['package.xml']", "['package.xml', 'a.txt']"), "SET205"),
    "tests are installed as a module": (
        both(swap(SETUP, "exclude=['test']", ""), put("test/__init__.py", "")),
        "SET303",
    ),
    "two entry points of one name": (
        before(SETUP, "'talker = ", "            'talker = my_robot.greeting:Greeting',\n"),
        "SET104",
    ),
}
MANIFEST_FAULTS = {
    "an undeclared import of a library": (swap(NODE, IMPORT, f"import cv2\n{IMPORT}"), "DEP101"),
    "an undeclared import of messages": (
        swap(NODE, IMPORT, f"{IMPORT}from sensor_msgs.msg import Imu  # noqa: F401\n"),
        "DEP101",
    ),
    "a dependency that nothing uses": (
        before(MANIFEST, "<exec_depend>std_msgs", "  <exec_depend>shape_msgs</exec_depend>\n"),
        "DEP202",
    ),
    "ament_cmake without CMakeLists.txt": (swap(MANIFEST, ">ament_python<", ">ament_cmake<"), "XML304"),
    "a misspelt build type": (swap(MANIFEST, ">ament_python<", ">ament_pyton<"), "XML302"),
    "no build type": (line(MANIFEST, "<build_type>"), "XML301"),
    "an e-mail that is none": (swap(MANIFEST, 'email="', 'email="at '), "XML105"),
    "a maintainer without e-mail": (swap(MANIFEST, ' email="ada@example.org"', ""), "XML105"),
    "a name in capitals": (swap(MANIFEST, "<name>my_robot", "<name>My_Robot"), "XML101"),
    "a name with a dash": (swap(MANIFEST, "<name>my_robot", "<name>my-robot"), "XML101"),
    "a version of two numbers": (swap(MANIFEST, "<version>0.1.0", "<version>0.1"), "XML103"),
    "a dependency twice": (before(MANIFEST, "<exec_depend>rclpy", "  <exec_depend>rclpy</exec_depend>\n"), "XML201"),
    "depend beside exec_depend": (before(MANIFEST, "<exec_depend>launch<", "  <depend>rclpy</depend>\n"), "XML202"),
    "an unknown tag": (swap(MANIFEST, "exec_depend>rclpy</exec_depend", "dependency>rclpy</dependency"), "XML001"),
    "run_depend in format 3": (
        swap(MANIFEST, "exec_depend>rclpy</exec_depend", "run_depend>rclpy</run_depend"),
        "XML001",
    ),
    "license before version": (
        both(line(MANIFEST, "<license>"), before(MANIFEST, "<version>", "  <license>Apache-2.0</license>\n")),
        "XML002",
    ),
    "format 9": (swap(MANIFEST, 'format="3"', 'format="9"'), "XML003"),
    "no format": (swap(MANIFEST, ' format="3"', ""), "XML003"),
    "no license": (line(MANIFEST, "<license>"), "XML001"),
    "a license to do": (swap(MANIFEST, "<license>Apache-2.0", "<license>TODO: License"), "XML104"),
    "a description to do": (line(MANIFEST, "<description>", "  <description>TODO</description>\n"), "XML104"),
    "a license of no SPDX id": (swap(MANIFEST, "<license>Apache-2.0", "<license>Apache 2"), "XML110"),
    "XML that is none": (swap(MANIFEST, "</version>", "</versoin>"), "RPK001"),
    "a key that nobody knows": (swap(MANIFEST, "exec_depend>rclpy", "exec_depend>rclypy"), "DEP001"),
    "a key by its name on PyPI": (
        both(
            before(MANIFEST, "<exec_depend>rcl_int", "  <exec_depend>opencv-python</exec_depend>\n"),
            swap(NODE, IMPORT, f"import cv2\n{IMPORT}"),
        ),
        "DEP001",
    ),
    "itself as a dependency": (
        before(MANIFEST, "<exec_depend>nav_msgs", "  <exec_depend>my_robot</exec_depend>\n"),
        "XML203",
    ),
    "a condition that is none": (
        swap(MANIFEST, "<exec_depend>rclpy", '<exec_depend condition="$ROS_VERSION = 2">rclpy'),
        "XML204",
    ),
    "no text of the license": (drop("LICENSE"), "XML111"),
}
LAUNCH_FAULTS = {
    "launch.py starts what is not there": (swap(LAUNCH, "executable='talker'", "executable='taker'"), "LCH002"),
    "launch.xml starts what is not there": (swap(XML, 'exec="talker"', 'exec="taker"'), "LCH002"),
    "launch.py names a file that is not there": (swap(LAUNCH, "'params.yaml'", "'parms.yaml'"), "LCH003"),
    "launch.xml names a file that is not there": (swap(XML, "params.yaml", "parms.yaml"), "LCH003"),
    "launch.yaml names a file that is not there": (swap(YAML, "params.yaml", "parms.yaml"), "LCH003"),
    "launch.py uses an undeclared package": (
        swap(LAUNCH, "        Node(\n", "        Node(package='nav2_bringup', executable='other'),\n        Node(\n"),
        "DEP103",
    ),
    "launch.xml in the words of ROS 1": (
        swap(XML, 'pkg="my_robot" exec="talker"', 'pkg="my_robot" type="talker"'),
        "LCH005",
    ),
    "launch.xml finds in the words of ROS 1": (swap(XML, "find-pkg-share", "find"), "LCH006"),
    "launch.py describes nothing": (swap(LAUNCH, "def generate_launch_description", "def describe"), "LCH001"),
    "launch.py that is no Python": (before(LAUNCH, "def generate", SYNTAX), "RPK001"),
    "launch.py in the words of Dashing": (swap(LAUNCH, "executable=", "node_executable="), "LCH005"),
    "parameters without ros__parameters": (line(PARAMS, "ros__parameters"), "PRM001"),
    "parameters with one underscore": (swap(PARAMS, "ros__parameters", "ros_parameters"), "PRM001"),
    "a parameter twice": (swap(PARAMS, "    rate:", "    text: again\n    rate:"), "PRM002"),
    "parameters of a node that nothing starts": (swap(PARAMS, "/**:", "taker:"), "PRM003"),
    "parameters that are no YAML": (swap(PARAMS, "    rate: 1.0", "    rate: [1.0"), "RPK001"),
    "a joint of a link that is not there": (
        swap("urdf/my_robot.urdf", 'link="wheel"/></joint>', 'link="whel"/></joint>'),
        "URD001",
    ),
}
FAULTS = SETUP_FAULTS | MANIFEST_FAULTS | LAUNCH_FAULTS


def test_without_a_fault_nothing_is_said() -> None:
    assert [(f.code, f.message) for f in lint_files(sound()).findings] == []


@pytest.mark.parametrize("fault", FAULTS)
def test_each_fault_is_named(fault: str) -> None:
    change, code = FAULTS[fault]
    files = sound()
    change(files)
    found = [(f.code, f.message) for f in lint_files(files).findings]
    assert {each for each, _ in found} == {code}, found
