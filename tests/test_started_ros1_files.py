"""LCH006: launch files for ROS 1 bite somebody only where something for ROS 2 starts them."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

INSTALLS = "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package"
OLD = '<launch>\n  <node pkg="my_pkg" type="talker" name="talker"/>\n</launch>\n'
NEW = '<launch>\n  <include file="$(find-pkg-share {})/launch/{}"/>\n</launch>\n'
CODE = "import subprocess\n\nsubprocess.run(['ros2', 'launch', {}, 'old.launch'])\n"
FILES = {
    "my_pkg/package.xml": manifest("", "ament_cmake"),
    "my_pkg/CMakeLists.txt": CMAKE.replace("ament_package", INSTALLS),
    "my_pkg/launch/old.launch": OLD,
    "other/package.xml": manifest("", "ament_cmake", "other"),
    "other/CMakeLists.txt": CMAKE.replace("my_pkg", "other").replace("ament_package", INSTALLS),
}


def levels(more: dict[str, str]) -> list[str]:
    return [each.severity.value for each in lint_files({**FILES, **more}, ["LCH006"]).findings]


@pytest.mark.parametrize(
    "more",
    [
        {},
        {"my_pkg/launch/older.launch": '<launch>\n  <include file="$(find my_pkg)/launch/old.launch"/>\n</launch>\n'},
        {"my_pkg/README.md": "    roslaunch my_pkg old.launch\n"},
        {"my_pkg/README.md": "`old.launch` starts the talker, `ros2 launch` is not for it.\n"},
        {"my_pkg/README.md": "    ros2 launch other old.launch\n"},
        {"my_pkg/scripts/start.py": CODE.format("'other'")},
        {"other/launch/new.launch.xml": NEW.format("other", "old.launch"), "other/launch/old.launch": "<launch/>\n"},
    ],
)
def test_what_nothing_for_ros2_starts_is_an_info(more: dict[str, str]) -> None:
    assert levels(more) == ["info"]


@pytest.mark.parametrize(
    "more",
    [
        {"my_pkg/README.md": "    ros2 launch my_pkg old.launch speed:=2\n"},
        {"README.md": "    ros2 launch src/my_pkg/launch/old.launch\n"},
        {"my_pkg/start.sh": "ros2 launch my_pkg old.launch &\n"},
        {"my_pkg/scripts/start.py": CODE.format("'my_pkg'")},
        {"my_pkg/launch/new.launch.xml": NEW.format("my_pkg", "old.launch")},
        {"other/launch/new.launch.xml": NEW.format("my_pkg", "old.launch")},
    ],
)
def test_what_something_for_ros2_starts_is_a_warning(more: dict[str, str]) -> None:
    assert levels(more) == ["warning"]


def test_files_that_are_started_and_others_are_two_findings() -> None:
    more = {"my_pkg/launch/spare.launch": OLD, "my_pkg/README.md": "    ros2 launch my_pkg old.launch\n"}
    assert sorted(levels(more)) == ["info", "warning"]
