"""Packages that need each other, undeclared: to declare what is missing would make a circle that colcon stops at."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, SETUP_PY, SETUP_PY_FOR_ALL, manifest
from rospkg_cli.testing import lint_files

CODES = ["DEP101", "DEP102", "DEP103", "DEP104", "DEP106", "DEP116"]
STARTS = '<launch><node pkg="{}" exec="talker"/></launch>\n'
LOOKS = "from ament_index_python import get_package_share_directory\n\nA = get_package_share_directory('{}')\n"
CAUGHT = LOOKS.replace("A = ", "try:\n    A = ") + "except Exception:\n    A = ''\n"
ROBOT = '<robot xmlns:xacro="x" name="r"><xacro:include filename="$(find {})/urdf/a.xacro"/></robot>\n'
TEST = "import {}\n\n\ndef test_it():\n    assert {}\n"
NEEDS = "  <depend>ament_index_python</depend>\n  <exec_depend>ros2launch</exec_depend>\n"
LAUNCH, OTHER_LAUNCH = ("launch/a.launch.xml", STARTS), ("launch/b.launch.xml", STARTS)


def package(name: str, depends: str, path: str, text: str) -> dict[str, str]:
    files = {
        "package.xml": manifest(NEEDS + depends).replace("my_pkg<", f"{name}<", 1),
        "setup.py": SETUP_PY_FOR_ALL.replace("my_pkg", name),
        f"resource/{name}": "",
        f"{name}/__init__.py": "",
        path: text,
    }
    return {f"{name}/{each}": content for each, content in files.items()}


def told(files: dict[str, str]) -> list[tuple[str, str, bool, bool]]:
    """Return of each finding its package and level, and whether it tells of a circle and has a fix."""
    found = lint_files(files, CODES).findings
    return [(f.package, f.severity.value, "a circle" in f.message, f.fix is not None) for f in found]


def two(arm: tuple[str, str], hand: tuple[str, str]) -> dict[str, str]:
    return package("arm", "", arm[0], arm[1].format("hand", "hand")) | package(
        "hand", "", hand[0], hand[1].format("arm", "arm")
    )


NONE, ASKED = (("info", True, False), ("warning", False, True))


@pytest.mark.parametrize(
    ("arm", "hand", "expected"),
    [
        (LAUNCH, OTHER_LAUNCH, (NONE, NONE)),
        (LAUNCH, ("hand/node.py", LOOKS), (NONE, NONE)),
        (("arm/node.py", LOOKS), ("hand/node.py", LOOKS), (NONE, NONE)),
        (("arm/node.py", "import {}\n"), ("hand/node.py", "import {}\n"), (NONE, NONE)),
        (("arm/node.py", "import {}\n"), OTHER_LAUNCH, (ASKED, NONE)),  # the file is easier to move than the code
        (LAUNCH, ("hand/node.py", CAUGHT), (ASKED,)),
        (LAUNCH, ("hand/node.py", "# get_package_share_directory('{}')\n"), (ASKED,)),
        (LAUNCH, ("test/test_hand.py", TEST), (ASKED, NONE)),  # what tests alone need keeps nobody from being declared
        (LAUNCH, ("test/b.launch.xml", STARTS), (ASKED, NONE)),
        (LAUNCH, ("launch/demo_b.launch.xml", STARTS), (ASKED, NONE)),
    ],
)
def test_packages_that_need_each_other(
    arm: tuple[str, str], hand: tuple[str, str], expected: tuple[tuple[str, bool, bool], ...]
) -> None:
    assert told(two(arm, hand)) == [(name, *each) for name, each in zip(("arm", "hand"), expected, strict=False)]


@pytest.mark.parametrize(("declares", "level"), [("", "warning"), ("  <exec_depend>arm</exec_depend>\n", "info")])
def test_a_circle_by_way_of_others(declares: str, level: str) -> None:
    files = package("arm", "", "launch/a.launch.xml", STARTS.format("hand"))
    files |= package("hand", "", "launch/b.launch.xml", STARTS.format("finger"))
    files |= package("finger", declares, "finger/node.py", "A = 1\n")
    found = {f.package: f for f in lint_files(files, CODES).findings}
    assert found["arm"].severity.value == level
    assert ("by way of `finger`" in found["arm"].message) == (level == "info")
    assert found["hand"].severity.value == level


def test_what_may_not_be_declared_keeps_nobody_from_being_declared() -> None:
    """The hand starts what waits for it already: that is its own fault, and no reason for the arm."""
    files = package("arm", "", "launch/a.launch.xml", STARTS.format("hand"))
    files |= package("hand", "", "launch/b.launch.xml", STARTS.format("robot"))
    needs = "  <exec_depend>arm</exec_depend>\n  <exec_depend>hand</exec_depend>\n"
    files |= package("robot", needs, "robot/node.py", "A = 1\n")
    assert told(files) == [("arm", *ASKED)]


def test_a_launch_file_that_nothing_installs_keeps_nobody_from_being_declared() -> None:
    files = two(LAUNCH, OTHER_LAUNCH) | {"hand/setup.py": SETUP_PY.replace("my_pkg", "hand")}
    assert told(files)[0] == ("arm", *ASKED)


def test_who_needs_it_is_told() -> None:
    first, second = lint_files(two(LAUNCH, OTHER_LAUNCH), CODES).findings
    assert first.message.endswith(
        "to declare it would make a circle, for `hand` needs this package in `launch/b.launch.xml`: move one of the "
        "two files to a package above both"
    )
    assert "`launch/a.launch.xml`" in second.message


def test_a_robot_that_needs_its_bringup() -> None:
    cmake = CMAKE.replace(
        "ament_package()", "install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\nament_package()"
    )
    files = {
        "arm/package.xml": manifest("", "ament_cmake", "arm"),
        "arm/CMakeLists.txt": cmake.replace("my_pkg", "arm"),
        "arm/urdf/arm.urdf.xacro": ROBOT.format("hand"),
        "arm/README.md": "    xacro urdf/arm.urdf.xacro\n",
    }
    hand = package("hand", "", "launch/b.launch.xml", STARTS.format("arm"))
    assert told(files | hand) == [("arm", *NONE), ("hand", *NONE)]
    hand = package("hand", "", "hand/node.py", "A = 1\n")
    assert told(files | hand) == [("arm", *ASKED)]


def test_what_others_bring_is_not_declared_in_a_circle_either() -> None:
    """The fix of an info for several declares those alone that may be declared."""
    files = two(LAUNCH, OTHER_LAUNCH)
    files["arm/launch/c.launch.xml"] = STARTS.format("tf2_ros")
    files["arm/package.xml"] = manifest(NEEDS + "  <depend>someones_package</depend>\n", name="arm")
    found = [f for f in lint_files(files, CODES).findings if f.package == "arm"]
    assert [(f.severity.value, "a circle" in f.message, f.fix is not None) for f in found] == [
        ("info", True, False), ("info", False, True)
    ]  # fmt: skip
