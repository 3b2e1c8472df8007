"""Scripts that can't be executed and came with their folder (CMK105): whether anybody is shown to run them."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import TreeEntry

FOLDER = "install(DIRECTORY tools/ nodes/ DESTINATION lib/${PROJECT_NAME})\n"
FILES = FOLDER.replace("DIRECTORY tools/ nodes/", "FILES tools/imu.py")
TOOL = "#!/usr/bin/env python3\nimport {}\n\nif __name__ == '__main__':\n    print('imu')\n"
NODE = {"tools/imu.py": TOOL.format("rclpy")}
USER = {"nodes/imu_node.py": "from support.tools import imu\n"}
LAUNCH = '<launch><node pkg="my_pkg" exec="imu.py"/></launch>\n'
ROBOT = {"robot/package.xml": manifest("", "ament_cmake", "robot"), "robot/launch/robot.launch.xml": LAUNCH}


@pytest.mark.parametrize(
    ("lines", "files", "level"),
    [
        (FOLDER, NODE, "error"),
        (FOLDER, NODE | USER, "info"),
        (FOLDER, {"tools/imu.py": TOOL.format("serial")}, "info"),
        (f"{FOLDER}# tools/imu.py\n", NODE, "info"),
        (f"{FOLDER}# my_tools/other_imu.py\n", NODE, "error"),
        (FOLDER, NODE | USER | {"launch/imu.launch.xml": LAUNCH}, "error"),
        (FOLDER, NODE | USER | {"README.md": "Try `ros2 run my_pkg imu.py`.\n"}, "error"),
        (FILES, NODE | USER, "error"),
    ],
)
def test_who_runs_a_script(lines: str, files: dict[str, str], level: str) -> None:
    text = CMAKE.replace("ament_package", f"{lines}ament_package")
    package = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": text, **files}
    own = lint_files(package, ["CMK105"]).findings
    assert [f.severity.value for f in own] == [level]


def test_a_launch_file_of_another_package_runs_it() -> None:
    text = CMAKE.replace("ament_package", f"{FOLDER}ament_package")
    package = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": text, **NODE, **USER}
    files = {f"my_pkg/{path}": each for path, each in package.items()}
    (found,) = lint_files({**files, **ROBOT}, ["CMK105"]).findings
    assert found.severity.value == "error"


PROGRAM = FILES.replace("FILES", "PROGRAMS")
KEPT = FOLDER.replace(")\n", " USE_SOURCE_PERMISSIONS)\n")
README = {"README.md": "Try `ros2 run my_pkg imu.py`.\n"}


@pytest.mark.parametrize(
    ("lines", "code", "more", "level"),
    [
        (PROGRAM, "rclpy", {}, "info"),
        (PROGRAM, "rclpy", README, "warning"),
        (PROGRAM, "rclpy", {"launch/imu.launch.xml": LAUNCH}, "warning"),
        (KEPT, "rclpy", {}, "info"),
        (KEPT, "rclpy", README, "error"),
        (FOLDER, "rclpy", {}, "warning"),
        (FOLDER, "rclpy", README, "error"),
        (FILES, "rclpy", {}, "error"),
        (FILES, "serial", {}, "warning"),
        (FILES, "serial", README, "error"),
    ],
)
def test_a_bit_that_a_copy_may_have_lost(lines: str, code: str, more: dict[str, str], level: str) -> None:
    text = CMAKE.replace("ament_package", f"{lines}ament_package")
    script = TreeEntry("file", TOOL.format(code).encode(), 0o644)
    files = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": text, **more, "tools/imu.py": script}
    (found,) = lint_files(files, ["CMK105"]).findings
    assert found.severity.value == level
    assert ("may lose the bit" in found.message) is (level == "info")
