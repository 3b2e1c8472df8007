"""What a module imports that only a script imports whose install stands in a comment is an info (DEP101, DEP117)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

BUILD = """\
find_package(ament_cmake_python REQUIRED)
add_executable(node src/node.cpp)
install(TARGETS node DESTINATION lib/${PROJECT_NAME})
ament_python_install_package(${PROJECT_NAME})
"""
RULE = "install(PROGRAMS\n  scripts/finder_node.py\n  DESTINATION lib/${PROJECT_NAME}\n  RENAME finder_node\n)\n"
COMMENT = "".join(f"# {line}\n" for line in RULE.splitlines())
FILES = {
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n", "ament_cmake"),
    "src/node.cpp": "int main() {return 0;}\n",
    "my_pkg/__init__.py": "",
    "my_pkg/finder.py": "import rclpy\nfrom trajectory_msgs.msg import JointTrajectory\n\n\nclass Finder: ...\n",
    "scripts/finder_node.py": "from my_pkg.finder import Finder\n\n\nif __name__ == '__main__':\n    Finder()\n",
}


NODE = FILES["my_pkg/finder.py"].replace("...", "NAME = 'finder_node'")
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    finder_node = Node(package='my_pkg', executable='node', name='finder_node')
    return LaunchDescription([finder_node])
"""


def levels(build: str, **others: str) -> list[str]:
    text = CMAKE.replace("ament_package", f"{BUILD}{build}ament_package")
    files = {**FILES, "CMakeLists.txt": text, **{name.replace("__", "/"): each for name, each in others.items()}}
    return [each.severity.value for each in lint_files(files, ["DEP101"]).findings]


@pytest.mark.parametrize(
    "build, others, level",
    [
        (COMMENT, {}, "info"),
        (COMMENT.replace("PROGRAMS\n#   ", "PROGRAMS "), {}, "info"),
        (f"#[[\n{RULE}]]\n", {}, "info"),
        (RULE, {}, "warning"),
        (COMMENT + RULE, {}, "warning"),
        ("", {}, "warning"),
        (COMMENT, {"README.md": "Start it by `python3 scripts/finder_node.py`.\n"}, "warning"),
        (COMMENT, {"start.sh": "ros2 run my_pkg finder_node\n"}, "warning"),
        (COMMENT, {"launch__all.launch.xml": '<launch><node pkg="my_pkg" exec="finder_node"/></launch>'}, "warning"),
        (COMMENT, {"launch__a.launch.py": LAUNCH}, "info"),
        (COMMENT, {"launch__a.launch.py": LAUNCH.replace("'node'", "'finder_node'")}, "warning"),
        (COMMENT, {"my_pkg__other.py": "from my_pkg.finder import Finder\n"}, "info"),
        (COMMENT, {"scripts__other.py": "from my_pkg.finder import Finder\n"}, "warning"),
        (COMMENT, {"scripts__other.py": "import finder_node\n"}, "warning"),
        (COMMENT, {"my_pkg__finder.py": NODE}, "info"),
        (COMMENT, {"config__a.yaml": "finder_node:\n  ros__parameters:\n    a: 1\n"}, "info"),
        (COMMENT, {"my_pkg__start.py": "PROGRAM = 'scripts/finder_node.py'\n"}, "warning"),
        (COMMENT, {"test__test_finder.py": "from my_pkg.finder import Finder\n"}, "warning"),
    ],
)
def test_a_script_whose_install_is_a_comment_leads_nowhere(build: str, others: dict[str, str], level: str) -> None:
    assert levels(build, **others) == [level]
