"""PRM006: what code declares behind a prefix that only a run knows may be another parameter: an info."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

NODE = "add_executable(node src/node.cpp)\ninstall(TARGETS node DESTINATION lib/${PROJECT_NAME})\n"
INSTALL = "install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})\n"
CODE = """\
#include <rclcpp/rclcpp.hpp>
struct Frames : rclcpp::Node {{
  explicit Frames(const std::string & id) : Node("frames")
  {{
    declare_parameter<std::string>({}, "");
  }}
}};
int main() {{return 0;}}
"""
LAUNCH = """\
<launch>
  <node pkg="my_pkg" exec="node" name="frames"><param from="$(find-pkg-share my_pkg)/config/a.yaml"/></node>
</launch>
"""


@pytest.mark.parametrize(("name", "level"), [('id + ".x"', "info"), ('"gate.x"', "warning")])
def test_a_type_that_is_declared_behind_an_unknown_prefix(name: str, level: str) -> None:
    files = {
        "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{NODE}{INSTALL}ament_package"),
        "src/node.cpp": CODE.format(name),
        "config/a.yaml": "frames:\n  ros__parameters:\n    gate:\n      x: 1.0\n",
        "launch/a.launch.xml": LAUNCH,
    }
    (found,) = lint_files(files, ["PRM006"]).findings
    assert found.severity.value == level
