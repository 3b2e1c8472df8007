"""Where other linters cry wolf about dependencies: not one of our rules says a word there."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.rule import Profile, all_rules
from rospkg_cli.testing import lint_files

PYTHON = existing_files(BACKDROPS["ament_python"])
CPP = existing_files(BACKDROPS["ament_cmake"])
CODES = [rule.code for rule in all_rules() if rule.family == "DEP" and rule.profile is Profile.DEFAULT]
NODE = "add_executable(node src/node.cpp)\ninstall(TARGETS node DESTINATION lib/${PROJECT_NAME})\n"


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package()", f"{lines}\nament_package()")


def built(lines: str, body: str = "", **files: str) -> dict[str, str]:
    return {**CPP, "package.xml": manifest(body, "ament_cmake"), "CMakeLists.txt": cmake(lines), **files}


TRAPS: dict[str, dict[str, str]] = {
    "tests without __init__.py import each other": {
        **PYTHON,
        "test/helpers.py": "",
        "test/test_a.py": "import helpers\nfrom test.helpers import x\n",
    },
    "optional parts of a build": built(
        "find_package(rclcpp QUIET)\nif(rclcpp_FOUND)\n  find_package(std_msgs REQUIRED)\nendif()\n"
        "if(WIN32)\n  find_package(nav_msgs REQUIRED)\nendif()"
    ),
    "what comes with the build tools": built(
        "find_package(ament_cmake_core REQUIRED)\nfind_package(Threads REQUIRED)\nfind_package(PkgConfig REQUIRED)"
    ),
    "CMake's names for libraries": built(
        "find_package(Eigen3 REQUIRED)\nfind_package(OpenCV REQUIRED)",
        "  <depend>eigen</depend>\n  <depend>libopencv-dev</depend>\n",
    ),
    "comments and docs of launch files": {
        **PYTHON,
        "launch/a.launch.xml": '<launch>\n  <!-- <node pkg="old" exec="x"/> -->\n</launch>\n',
        "launch/b.launch.py": '"""Starts Node(package=\'old\', executable=\'x\')."""\n'
        "from launch import LaunchDescription\n\n\ndef generate_launch_description():\n"
        "    return LaunchDescription([])  # Node(package='older', executable='x')\n",
        "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
    },
    "manifests and code among templates and fixtures": {
        **PYTHON,
        "templates/package.xml.in": "<package><depend>@X@</depend></package>\n",
        "my_pkg/templates/node.py": "import cv2\n",
        "resource/template/node.py": "import cv2\n",
        "test/fixtures/node.py": "import cv2\n",
    },
    "a package of ROS 1": {
        "package.xml": manifest("  <depend>roscpp</depend>\n", "catkin"),
        "CMakeLists.txt": "project(my_pkg)\nfind_package(catkin REQUIRED COMPONENTS roscpp tf)\ncatkin_package()\n",
        "src/node.cpp": "#include <ros/ros.h>\n#include <nav_msgs/Odometry.h>\n",
    },
    "a package for both, by conditions": {
        **PYTHON,
        "package.xml": manifest(
            '  <depend condition="$ROS_VERSION == 1">rospy</depend>\n'
            '  <depend condition="$ROS_VERSION == 2">rclpy</depend>\n'
        ),
        "my_pkg/node.py": "import rclpy\n",
    },
    "vendored code": {
        **PYTHON,
        "third_party/yaml/__init__.py": "import cv2\n",
        "my_pkg/vendor/lxml/__init__.py": "",
        "my_pkg/node.py": "import lxml\n",
    },
    "imports that a file does without": {
        **PYTHON,
        "my_pkg/node.py": "from typing import TYPE_CHECKING\ntry:\n    import cv2\nexcept ImportError:\n    pass\n"
        "if TYPE_CHECKING:\n    import numpy\n",
    },
    "modules of the package itself": {
        **PYTHON,
        "my_pkg/yaml.py": "x = y = 1\n",
        "my_pkg/node.py": "from . import yaml\nfrom my_pkg.yaml import x\nfrom .yaml import y\n",
    },
    "ament_auto takes what is declared": built(
        "find_package(ament_cmake_auto REQUIRED)\nament_auto_find_build_dependencies()\n"
        "ament_auto_add_executable(node src/node.cpp)",
        "  <buildtool_depend>ament_cmake_auto</buildtool_depend>\n  <depend>rclcpp</depend>\n",
        **{"src/node.cpp": "#include <rclcpp/rclcpp.hpp>\nint main() {return 0;}\n"},
    ),
    "pluginlib's macro asks for class_loader": built(
        f"find_package(pluginlib REQUIRED)\n{NODE}target_link_libraries(node pluginlib::pluginlib)",
        "  <depend>pluginlib</depend>\n",
        **{"src/node.cpp": "#include <pluginlib/class_list_macros.hpp>\n#include <class_loader/class_loader.hpp>\n"},
    ),
    "messages that only Python uses need no find_package": built(
        "find_package(ament_cmake_python REQUIRED)\nament_python_install_package(my_pkg)",
        "  <depend>std_msgs</depend>\n  <exec_depend>rclpy</exec_depend>\n",
        **{"my_pkg/__init__.py": "import rclpy\nfrom std_msgs.msg import String\n"},
    ),
    "packages of messages that hold none": {
        **PYTHON,
        "package.xml": manifest("  <exec_depend>tf2_geometry_msgs</exec_depend>\n"),
        "my_pkg/node.py": "import tf2_geometry_msgs\n",
    },
    "nodes of tests are there for tests": {
        **PYTHON,
        "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n  <test_depend>joy</test_depend>\n"),
        "test/a.launch.xml": '<launch>\n  <node pkg="joy" exec="joy_node"/>\n</launch>\n',
    },
}


@pytest.mark.parametrize("trap", TRAPS)
def test_traps(trap: str) -> None:
    found = lint_files(TRAPS[trap], CODES).findings
    assert [f"{finding.code} {finding.message}" for finding in found] == []


def test_siblings_are_known_without_any_index() -> None:
    files = {f"a/{path}": text for path, text in PYTHON.items()}
    files |= {f"b/{path}": text.replace("my_pkg", "acme_driver") for path, text in PYTHON.items()}
    files["a/package.xml"] = manifest("  <exec_depend>acme_driver</exec_depend>\n")
    assert lint_files(files, CODES).findings == ()
