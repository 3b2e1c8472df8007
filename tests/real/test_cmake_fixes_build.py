"""What --fix makes of every fixable example of the CMake and interface rules, under real colcon and ament_cmake.

Each example is a package: broken, it does not build, or lacks something where it is installed; mended, it builds and
has it.  rclcpp is a stand-in, the messages are real rosidl's.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from messages import message_prefix
from shell import Shell
from testing_new import PREFIX

from rospkg_cli.example import Example, manifest
from rospkg_cli.rule import all_rules

pytestmark = [pytest.mark.debian, pytest.mark.network]
ELF = b"\x7fE"
SOURCE = Path(__file__).parents[2] / "src"

EXAMPLES = {
    f"{rule.code.lower()}_{number}": example
    for rule in all_rules()
    for number, example in enumerate(rule.examples)
    if rule.code.startswith(("CMK", "IDL")) and example.fix is not None
}
NOT_HERE = {"idl004_1", "idl004_2"}
"""They use geometry_msgs and sensor_msgs, which nobody has made here."""

INSTALLED = {
    "cmk003_0": "share/ament_index/resource_index/packages/NAME",
    "cmk004_0": "share/NAME/cmake/ament_cmake_export_include_directories-extras.cmake",
    "cmk005_0": "lib/NAME/talker",
    "cmk005_1": "lib/NAME/talker",
    "cmk101_0": "share/NAME/launch/robot.launch.xml",
    "cmk101_1": "share/NAME/rviz/robot.rviz",
    "cmk103_0": "lib/NAME/listener",
    "cmk103_1": "lib/libcore.so",
    "cmk104_0": "lib/NAME/talker",
    "cmk104_1": "lib/NAME/talker",
    "cmk105_0": "lib/NAME/hello.py",
    "cmk105_1": "lib/NAME/hello.py",
    "cmk105_2": "lib/NAME/hello.py",
    "cmk106_0": "include/NAME/NAME/core.hpp",
    "cmk109_0": "**/NAME/words.py",
    "cmk111_0": "share/NAME/urdf/robot.urdf",
    "cmk112_0": "lib/NAME/bye.py",
    "idl005_0": "share/NAME/msg/Battery.msg",
    "idl005_1": "share/NAME/msg/Zone.msg",
}
"""What was missing, where that is more than a build that ends."""

WORKS_ANYWAY = {
    *("cmk002_0", "cmk002_1", "cmk005_0", "cmk005_1", "cmk107_0", "cmk113_0", "idl001_6"),
    *("cmk109_1", "cmk117_0", "cmk118_0", "idl010_0", "idl010_1", "idl011_1"),
}
"""Nothing is missing before: another CMake stops, or another package, what runs, or a machine without linters."""

NOT_TRIED = {"cmk111_0"}
"""It would install into the system."""

USER = {
    "package.xml": manifest("  <depend>OTHER</depend>\n", "ament_cmake", "user_pkg").replace("OTHER", "cmk113_0"),
    "CMakeLists.txt": "cmake_minimum_required(VERSION 3.20)\nproject(user_pkg)\nfind_package(ament_cmake REQUIRED)\n"
    "find_package(cmk113_0 REQUIRED)\nadd_executable(use use.cpp)\ntarget_link_libraries(use cmk113_0::core)\n"
    "install(TARGETS use DESTINATION lib/${PROJECT_NAME})\nament_package()\n",
    "use.cpp": "#include <cmk113_0/core.hpp>\nint main() {return 0;}\n",
}


@pytest.fixture
def shell_with_messages(debian_colcon: Shell) -> Shell:
    prefixes = os.pathsep.join((str(PREFIX), str(message_prefix(debian_colcon))))
    return Shell({**debian_colcon.variables, "CMAKE_PREFIX_PATH": prefixes})


def write(name: str, example: Example, workspace: Path) -> None:
    for path, text in example.bad_files().items():
        file = workspace / "src" / name / path.replace("my_pkg", name)
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text.replace("my_pkg", name))
        file.chmod(0o755 if text.startswith("#!") else 0o644)


def build(shell: Shell, workspace: Path) -> tuple[int, str]:
    options = ("--continue-on-error", "--cmake-args", "-DBUILD_TESTING=OFF")
    made = shell.run("colcon", "build", *options, cwd=workspace)
    return made.returncode, made.stderr


def is_whole(workspace: Path, name: str) -> bool:
    """Return whether a package was built, and has what was missing; programs must be executable."""
    prefix = workspace / "install" / name
    found = list(prefix.glob(INSTALLED.get(name, "share/NAME/package.xml").replace("NAME", name)))
    programs = (path for path in found if path.parent == prefix / "lib" / name)
    return bool(found) and all(os.access(path, os.X_OK) and path.read_bytes()[:2] in (b"#!", ELF) for path in programs)


def test_what_was_mended_builds_and_installs_what_was_missing(shell_with_messages: Shell, tmp_path: Path) -> None:
    names = EXAMPLES.keys() - NOT_HERE
    for name in names:
        write(name, EXAMPLES[name], tmp_path)
    for path, text in USER.items():
        (tmp_path / "src/user_pkg").mkdir(exist_ok=True)
        (tmp_path / "src/user_pkg" / path).write_text(text)
    options = ("--fix", "--fix-level", "info", "--unsafe-fixes", "--target", "humble,lyrical")
    shell_with_messages.run(
        sys.executable, "-m", "rospkg_cli", "lint", *options, tmp_path, cwd=tmp_path, PYTHONPATH=str(SOURCE)
    )
    assert build(shell_with_messages, tmp_path) == (0, "")
    assert {name for name in names if not is_whole(tmp_path, name)} == set()
    assert os.access(tmp_path / "install/user_pkg/lib/user_pkg/use", os.X_OK)
    assert not [path for path in tmp_path.rglob("src/*/CMakeLists.txt") if "ament_target_dep" in path.read_text()]


def test_without_the_fix_each_lacks_something(shell_with_messages: Shell, tmp_path: Path) -> None:
    """The other half of the proof: the faults are faults."""
    names = EXAMPLES.keys() - NOT_HERE - NOT_TRIED - WORKS_ANYWAY
    for name in names:
        write(name, EXAMPLES[name], tmp_path)
    build(shell_with_messages, tmp_path)
    assert {name for name in names if is_whole(tmp_path, name)} == set()


def test_the_tables_name_examples() -> None:
    assert EXAMPLES.keys() >= {*INSTALLED, *NOT_HERE, *WORKS_ANYWAY, *NOT_TRIED}
