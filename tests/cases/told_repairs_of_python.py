"""Faults that people repaired in Python packages, told again in small."""

from __future__ import annotations

from rospkg_cli.example import SETUP_PY, Example, manifest
from rospkg_cli.rules.setup import set302_package_not_installed as set302

from .setups import MAIN, python
from .shown_imports import MIXED, MIXED_CMAKE

ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
LAUNCHES = "from glob import glob\n" + SETUP_PY.replace(
    ENTRY,
    f"{ENTRY}        ('share/' + package_name + '/launch', glob('launch/*')),\n"
    "        ('share/' + package_name + '/config', glob('config/*')),\n",
)
BOTH = """\
import os
import xml.etree.ElementTree as ET
from setuptools import setup

version = ET.parse('package.xml').getroot().find('version').text
if {}:
    from catkin_pkg.python_setup import generate_distutils_setup

    setup(**generate_distutils_setup(packages=['my_pkg', 'my_pkg.speech']))
    exit(0)
else:
{}"""
ASKING = (
    "'ROS_VERSION' in os.environ and os.environ['ROS_VERSION'] == '1'",
    "os.environ.get('ROS_VERSION') == '1'",
    "'ROS_VERSION' not in os.environ or os.getenv('ROS_VERSION') != '2'",
    "'ROS_VERSION' in os.environ",
    "'ROS_VERSION' in names",
    "'ROS_DISTRO' in os.environ",
)


def for_both(condition: str) -> Example:
    """A setup.py for ROS 1 and 2, of which the latter leaves a package out."""
    listed = SETUP_PY.replace(set302.FOUND, "['my_pkg']").replace("from setuptools import find_packages, setup\n", "")
    lines = "".join(f"    {line}\n" if line else "\n" for line in listed.splitlines())
    speech = {"my_pkg/talker.py": f"from my_pkg.speech.words import A\n\n\n{MAIN}", "my_pkg/speech/__init__.py": ""}
    return python({"setup.py": BOTH.format(condition, lines), **speech, "my_pkg/speech/words.py": "A = 1\n"})


def of_cmake(line: str) -> Example:
    """A package of CMake that imports two modules of its own, of which it has no file."""
    files = {**MIXED, "CMakeLists.txt": MIXED_CMAKE.replace("ament_package", f"{line}\nament_package")}
    text = "from .config.loaders import A\nimport my_pkg.nothing_alike\n"
    return Example(on="", bad={**files, "my_pkg/talker.py": text, "src/core.cpp": "int i;\n"}, good={})


def moved(*packages: str) -> Example:
    """A package that imports a module which other packages of the workspace have."""
    files = {f"a/{path}": each for path, each in MIXED.items()}
    for name in packages:
        files |= {
            f"{name}/{path.replace('my_pkg', name)}": each.replace("my_pkg", name) for path, each in MIXED.items()
        }
        files |= {f"{name}/{name}/config/__init__.py": "", f"{name}/{name}/config/loader.py": "A = 1\n"}
    return Example(on="", bad={**files, "a/my_pkg/talker.py": "from .config.loader import A\n"}, good={})


MAKING = (
    "",
    "add_library(core SHARED src/core.cpp)",
    "pybind11_add_module(core src/core.cpp)",
    "configure_file(a.in a.py)",
    "add_custom_target(core ALL COMMAND a)",
    "include(${MODULES}/a.cmake)",
    "execute_process(COMMAND chmod +x a.py)",
    "execute_process(COMMAND /usr/bin/uname -m OUTPUT_VARIABLE a COMMAND a)",
    "configure_file(a.hpp.in a.hpp)",
    "add_library(core SHARED src/core.cpp)\nset_target_properties(core PROPERTIES CXX_STANDARD 17)",
    'add_library(core SHARED src/core.cpp)\nset_target_properties(core PROPERTIES PREFIX "")',
)

COPIED: tuple[tuple[str, dict[str, str]], ...] = (
    ("from their_pkg.words import A\n", {}),
    ("from their_pkg.words import *\n", {}),
    ("from their_pkg.words import B\n", {}),
    ("import their_pkg.words\nfrom their_pkg import core\n", {}),
    ("from numpy.words import A\n", {}),
    ("from their_pkg.words import A\n", {"requirements.txt": "their_pkg\n"}),
    ("from their_pkg.words import A\n", {"test/CMakeLists.txt": "file(WRITE their_pkg/words.py)\n"}),
    ("from their_pkg.words import A\nfrom their_pkg.words import *\n", {}),
    ("try:\n    from their_pkg.words import A\nexcept ImportError:\n    A = 1\n", {}),
)
HEAD = "from launch import LaunchDescription\nfrom launch_pal.include_utils import include_launch_py_description\n"
INCLUDE = """

def generate_launch_description():
    return LaunchDescription([include_launch_py_description({}, {})])
"""
INCLUDED = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument


def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('mood')])
"""
INCLUDES = (
    ("'nav2_bringup'", "['launch', 'bringup_launch.py']"),
    ("pkg_name='my_pkg'", "paths=['launch', 'absent.launch.py']"),
    ("'my_pkg'", "['launch', 'b.launch.py'], launch_arguments={'mode': 'fast'}.items()"),
    ("'my_pkg'", "parts"),
)
NEEDS = "  <exec_depend>launch_pal</exec_depend>\n  <exec_depend>launch</exec_depend>\n{}"


def including(package: str, parts: str) -> Example:
    """A launch file that includes one by a function of launch_pal."""
    files = {"launch/a.launch.py": HEAD + INCLUDE.format(package, parts), "setup.py": LAUNCHES}
    files["launch/b.launch.py"] = INCLUDED
    return python({**files, "package.xml": manifest(NEEDS.format(""))})


TYPES = """\
joy_teleop:
  ros__parameters:
    lift:
      type: action
      interface_type: {}
      # interface_type: nav2_msgs/action/Wait
"""
JOY = """\
<launch>
  <node pkg="joy_teleop" exec="joy_teleop"><param from="$(find-pkg-share my_pkg)/config/joy.yaml"/></node>
</launch>
"""


def told(interface: str, *needs: str, launch: str = JOY) -> Example:
    """Parameters of joy_teleop, which names what it sends by its type."""
    listed = "".join(f"  <exec_depend>{each}</exec_depend>\n" for each in ("joy_teleop", "launch_xml", *needs))
    files = {"config/joy.yaml": TYPES.format(interface), "launch/joy.launch.xml": launch, "setup.py": LAUNCHES}
    return python({**files, "package.xml": manifest(listed)})


def beside(destination: str) -> Example:
    """A module that data_files install, and that nobody imports as one of the package."""
    entry = f"        ('{destination}', ['my_pkg/readers/reader.py']),\n"
    files = {"setup.py": SETUP_PY.replace(ENTRY, ENTRY + entry), "my_pkg/readers/reader.py": "import serial\n"}
    return python({**files, "my_pkg/talker.py": f"from readers.reader import serial\n\n\n{MAIN}"})


CASES = {
    "DEP101": (beside("lib/my_pkg/readers"), beside("share/my_pkg/readers")),
    "DEP103": tuple(including(*each) for each in INCLUDES),
    "LCH003": tuple(including(*each) for each in INCLUDES),
    "LCH015": tuple(including(*each) for each in INCLUDES),
    "DEP106": (
        told("teleop_tools_msgs/action/Increment"),
        told("teleop_tools_msgs/action/Increment", "teleop_tools_msgs"),
        told("'nav2_msgs/action/Spin' # once"),
        told("nav2_msgs/action/Spin", launch="<launch/>\n"),
        told("my_own_msgs/msg/Mode"),
        told("Mode"),
    ),
    "DEP109": (
        *(python({"my_pkg/talker.py": text, "my_pkg/words.py": "A = 1\n", **files}) for text, files in COPIED),
        *map(of_cmake, MAKING),
        moved("other"),
        moved("other", "third"),
    ),
    "SET302": tuple(map(for_both, ASKING)),
}
