"""Fixes that are made together: new dependencies by their tags, and none that makes packages wait for each other."""

from __future__ import annotations

import re

import pytest

from rospkg_cli.engine.fixing.fix import fix_all
from rospkg_cli.engine.fixing.fix_results import FixResults
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.finding import Safety
from rospkg_cli.tree import MemoryTree

PYTHON = existing_files(BACKDROPS["ament_python"])


def fixed(files: dict[str, str], *codes: str) -> FixResults:
    folders = tuple(sorted({path.rpartition("/")[0] for path in files if path.endswith("package.xml")}))
    session = Session(MemoryTree.of(files), Scope(folders, frozenset(folders), "my_pkg"), frozenset(codes))
    return fix_all(session, (Safety.SAFE,))


def dependencies(found: FixResults, path: str) -> list[str]:
    entry = found.changes.get(path)
    assert entry is not None
    return re.findall(r"<\w*depend>[\w-]+", entry.text.text)


def test_new_dependencies_at_one_place_stand_by_their_tags_and_names() -> None:
    cmake = CMAKE.replace(
        "ament_package",
        "find_package(rclcpp REQUIRED)\nif(BUILD_TESTING)\n  find_package(ament_cmake_gmock REQUIRED)\n"
        "  find_package(ament_cmake_black REQUIRED)\nendif()\nament_package",
    )
    files = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": cmake}
    nodes = "".join(f'  <node pkg="{name}" exec="x"/>\n' for name in ("turtlebot3_node", "joy"))
    files["launch/a.launch.xml"] = f"<launch>\n{nodes}</launch>\n"
    found = fixed(files, "DEP103", "DEP104")
    assert dependencies(found, "package.xml") == [
        "<buildtool_depend>ament_cmake",
        "<depend>rclcpp",
        "<exec_depend>joy",
        "<exec_depend>turtlebot3_node",
        "<test_depend>ament_cmake_black",
        "<test_depend>ament_cmake_gmock",
    ]


def user(name: str, *needs: str) -> dict[str, str]:
    lines = "".join(f'  <node pkg="{need}" exec="x"/>\n' for need in needs)
    files = {path.replace("my_pkg", name): text.replace("my_pkg", name) for path, text in PYTHON.items()}
    files |= {"package.xml": manifest(name=name), "launch/a.launch.xml": f"<launch>\n{lines}</launch>\n"}
    return {f"{name}/{path}": text for path, text in files.items()}


def with_tests(name: str, *needs: str) -> dict[str, str]:
    """Return a package whose tests start nodes of others."""
    return {path.replace("/launch/", "/test/"): text for path, text in user(name, *needs).items()}


@pytest.mark.parametrize(
    ("files", "refused"),
    [
        (
            with_tests("a", "b") | with_tests("b", "a"),
            [("b", "`a` depends on `b`, or is to: colcon could build neither")],
        ),
        (
            with_tests("a", "b") | with_tests("b", "c") | with_tests("c", "a"),
            [("c", "`a` depends on `c`, or is to: colcon could build neither")],
        ),
        (with_tests("a", "b") | with_tests("b", "c") | with_tests("c"), []),
    ],
)
def test_no_packages_are_made_to_wait_for_each_other(files: dict[str, str], refused: list[tuple[str, str]]) -> None:
    found = fixed(files, "DEP103")
    assert [(finding.package, why) for finding, why in found.refused] == refused


@pytest.mark.parametrize(
    ("files", "declared"),
    [
        (user("a", "b") | user("b", "a"), []),
        (user("a", "b") | user("b", "c") | user("c", "a"), []),
        (user("a", "b") | user("b", "c") | user("c"), ["a/package.xml", "b/package.xml"]),
    ],
)
def test_what_would_close_a_circle_is_offered_to_none(files: dict[str, str], declared: list[str]) -> None:
    found = fixed(files, "DEP103")
    assert (sorted(found.changes), found.refused) == (declared, [])


def test_a_dependency_that_is_only_moved_closes_no_cycle() -> None:
    found = fixed({"package.xml": manifest("  <depend>rclpy</depend>\n  <depend>my_pkg</depend>\n")}, "XML206")
    assert (found.refused, dependencies(found, "package.xml")) == ([], ["<depend>my_pkg", "<depend>rclpy"])


def test_what_a_comment_leaves_out_keeps_no_other_from_being_declared() -> None:
    cmake = CMAKE.replace(
        "ament_package", "find_package(std_msgs REQUIRED)\nfind_package(rclcpp REQUIRED)\nament_package"
    )
    lines = "  <!-- <depend>std_msgs</depend> -->\n  <depend>rclcpp_action</depend>\n  <depend>nav_msgs</depend>\n"
    found = fixed({"package.xml": manifest(lines, "ament_cmake"), "CMakeLists.txt": cmake}, "DEP104")
    assert dependencies(found, "package.xml")[-3:] == ["<depend>rclcpp_action", "<depend>nav_msgs", "<depend>rclcpp"]
    (left,) = found.results.findings
    assert left.fix is not None
    assert (left.fix.title, left.fix.safety) == ("declare `std_msgs`", Safety.UNSAFE)
