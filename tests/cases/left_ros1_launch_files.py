"""Launch files for ROS 1 beside those for ROS 2, by who starts or includes them (LCH006)."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

OLD = '<launch>\n  <node pkg="my_pkg" type="a" name="a"/>\n</launch>\n'
INCLUDES = '<launch>\n  <include file="$(find{} my_pkg)/launch/a.launch"/>\n</launch>\n'
NEW = '<launch>\n  <let name="a" value="b"/>\n</launch>\n'
PYTHON = """\
import os

from launch import LaunchDescription


def helper():
    return os.path.join('launch', 'a.launch')
"""
INSTALL = "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package"
FILES = {
    "CMakeLists.txt": CMAKE.replace("ament_package", INSTALL),
    "launch/a.launch": OLD,
    "launch/new.launch.xml": NEW,
}


def beside(files: dict[str, str]) -> Example:
    return Example(on="ament_cmake", good={}, bad={**FILES, **files})


CASES = {
    "LCH006": (
        *map(
            beside,
            (
                {},
                {"README.md": "`ros2 launch my_pkg a.launch` starts it.\n"},
                {"README.md": "roslaunch my_pkg a.launch\n"},
                {"README.md": "ros2 launch my_pkg a.launch.py\n"},
                {"scripts/run.sh": "ros2 launch my_pkg a.launch\n"},
                {"launch/new.launch.xml": INCLUDES.format("-pkg-share")},
                {"launch/b.launch": INCLUDES.format("")},
                {"launch/b.launch": INCLUDES.format(""), "README.md": "ros2 launch my_pkg b.launch\n"},
                {"launch/new.launch.xml": f"<launch>\n  <!-- a.launch -->\n{NEW[9:]}"},
                {"launch/new.launch.xml": "", "launch/parts.py": PYTHON},
            ),
        ),
        Example(
            on="",
            good={},
            bad={f"my_pkg/{path}": text for path, text in FILES.items()}
            | {
                "my_pkg/package.xml": manifest("", "ament_cmake"),
                "other/package.xml": manifest("", "cmake", name="other"),
                "other/launch/o.launch.xml": INCLUDES.format("-pkg-share"),
            },
        ),
    )
}
