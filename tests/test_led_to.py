"""A launch file or YAML that can't be read: an error where something leads to it, an info where nothing does."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

GOOD = "<launch>\n</launch>\n"
BAD = {"launch/arm.launch.xml": "<launch>\n", "config/arm.yaml": "arm:\n  ros__parameters:\n\ta: 1\n"}
OTHER = {
    "other/package.xml": manifest("  <depend>the_pkg</depend>\n", "ament_cmake", "other").replace("the_pkg", "my_pkg"),
    "other/CMakeLists.txt": CMAKE.replace("my_pkg", "other"),
}


def found(path: str, **files: str) -> str:
    lines = f"install(DIRECTORY launch config DESTINATION share/${{PROJECT_NAME}})  # {path}\n"
    lines += "add_executable(a src/a.cpp)\n" if "my_pkg__src__a_DOT_cpp" in files else ""
    written = {
        "my_pkg/package.xml": manifest("", "ament_cmake"),
        "my_pkg/CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}ament_package"),
        "my_pkg/launch/robot.launch.xml": GOOD,
        f"my_pkg/{path}": BAD[path],
    }
    more = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in files.items()}
    (finding,) = lint_files({**written, **more}, ["RPK001"]).findings
    return finding.severity.value


@pytest.mark.parametrize("path", BAD)
def test_who_leads_to_a_broken_file(path: str) -> None:
    name = path.rpartition("/")[2]
    assert found(path) == "info"
    typed = f"    ros2 run my_pkg arm --params-file config/{name}\n"
    assert found(path, README_DOT_md=typed) == "error"
    assert found(path, README_DOT_md=f"See `{name}`.\n") == ("info" if name.endswith(".yaml") else "error")
    assert found(path, my_pkg__src__a_DOT_cpp=f'auto a = "{name}";\n') == "error"
    assert found(path, my_pkg__src__a_DOT_cpp=f'auto a = "big_{name}";\n') == "info"
    assert found(path, **OTHER, other__launch__all_DOT_launch_DOT_xml=f"<launch>{name}</launch>\n") == "error"


def test_the_only_launch_file_is_there_to_be_started() -> None:
    files = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": CMAKE, "launch/arm.launch.xml": "<launch>\n"}
    assert [each.severity.value for each in lint_files(files, ["RPK001"]).findings] == ["error"]


def test_a_name_that_is_put_together() -> None:
    text = "def generate_launch_description():\n    return LaunchDescription([LogInfo(msg={} + '.yaml')])\n"
    assert found("config/arm.yaml", my_pkg__launch__a_DOT_launch_DOT_py=text.format("name")) == "info"
    assert found("config/arm.yaml", my_pkg__launch__a_DOT_launch_DOT_py=text.format("'arm'")) == "error"
