"""Rules over the whole workspace: dependency cycles, versions of one repository, changelogs."""

from __future__ import annotations

import pytest

from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import MemoryTree


def packages(**needs: str) -> dict[str, str]:
    """Return packages by name: `talker="depend:msgs exec_depend:base"`."""
    found = {}
    for name, text in needs.items():
        lines = [each.split(":") for each in text.split()]
        body = "".join(f"  <{tag}>{other}</{tag.split(' ')[0]}>\n" for tag, other in lines)
        found[f"src/{name}/package.xml"] = manifest(body, "cmake", name)
    return found


def said(files: dict[str, str], code: str) -> list[tuple[str, str]]:
    return [(f.package, f.message) for f in lint_files(files, [code]).findings]


@pytest.mark.parametrize("tag", ["depend", "build_depend", "exec_depend", "test_depend", "buildtool_export_depend"])
def test_colcon_waits_for_it(tag: str) -> None:
    ((package, message),) = said(packages(a=f"{tag}:b", b="depend:c", c="build_depend:a"), "WSP002")
    assert package == "a"
    assert message.startswith("`a` → `b` → `c` → `a`: ")


@pytest.mark.parametrize(
    "needs",
    [
        {"a": "doc_depend:b", "b": "depend:a"},
        {"a": "depend:b conflict:b", "b": "depend:c", "c": ""},
        {"a": "depend:a"},
        {"a": "depend:b", "b": "depend:rclcpp"},
        {"a": "group_depend:g", "b": "depend:a", "c": "member_of_group:g"},
    ],
)
def test_no_cycle(needs: dict[str, str]) -> None:
    assert said(packages(**needs), "WSP002") == []


def test_a_condition_that_can_fail_makes_no_cycle() -> None:
    files = packages(a="depend:b", b="depend:a")
    for condition in ("$ROS_DISTRO == humble", "$MY_OWN == 1", "$ROS_VERSION == 1"):
        path = "src/a/package.xml"
        conditional = {path: files[path].replace("<depend>", f'<depend condition="{condition}">')}
        assert said({**files, **conditional}, "WSP002") == []
    always = {path: files[path].replace("<depend>", '<depend condition="$ROS_VERSION == 2">')}
    assert len(said({**files, **always}, "WSP002")) == 1


def test_each_knot_is_said_once_with_its_shortest_way() -> None:
    files = packages(a="depend:b", b="depend:c depend:a", c="depend:a", x="depend:y", y="test_depend:x")
    found = said(files, "WSP002")
    assert [(package, message.partition(":")[0]) for package, message in found] == [
        ("a", "`a` → `b` → `a`"),
        ("x", "`x` → `y` → `x`"),
    ]
    assert "`<test_depend>x` of `y`" in found[1][1]


MARK = {".github/workflows/ci.yml": ""}


def at(version: str, name: str) -> str:
    return manifest("", "cmake", name).replace("1.0.0", version)


def test_versions_are_compared_within_a_repository() -> None:
    files = {
        "src/one/.git/HEAD": "",
        "src/one/a/package.xml": at("1.0.0", "a"),
        "src/one/b/package.xml": at("1.0.0", "b"),
        "src/two/.git": "gitdir: elsewhere",
        "src/two/c/package.xml": at("2.0.0", "c"),
        "src/d/package.xml": at("3.0.0", "d"),
        "src/e/package.xml": at("4.0.0", "e"),
    }
    assert said(files, "WSP003") == []
    assert [package for package, _ in said({**files, **MARK}, "WSP003")] == ["d"]
    files["src/one/b/package.xml"] = at("1.0.1", "b")
    ((package, message),) = said(files, "WSP003")
    assert package == "a"
    assert "`b` has `1.0.1`" in message


def test_a_placeholder_is_not_what_the_others_should_have() -> None:
    files = {**MARK, **{f"{name}/package.xml": at("0.0.0", name) for name in "ab"}, "c/package.xml": at("1.2.0", "c")}
    found = said(files, "WSP003")
    assert [package for package, _ in found] == ["a", "b"]
    assert "write `1.2.0` here too" in found[0][1]


def test_what_is_no_version_is_no_version_that_differs() -> None:
    files = {**MARK, "a/package.xml": at("1.0.0", "a"), "b/package.xml": at("TODO", "b")}
    assert said(files, "WSP003") == []


def changelog(*titles: str) -> dict[str, str]:
    text = "".join(f"{title}\n{'-' * len(title)}\n* something\n\n" for title in titles)
    return {"package.xml": manifest(), "CHANGELOG.rst": text}


@pytest.mark.parametrize(
    "titles",
    [
        ["Forthcoming", "1.0.0 (2026-01-01)", "0.9.0 (2025-01-01)"],
        ["0.9.0 (2025-01-01)", "1.0.0 (2026-01-01)"],
        ["1.1.0 (forthcoming)", "1.0.0 (2026-01-01)"],
        ["Version 3"],
        ["1.0"],
        [],
    ],
)
def test_changelogs_that_bloom_takes(titles: list[str]) -> None:
    assert said(changelog(*titles), "WSP004") == []


@pytest.mark.parametrize(
    "titles, told",
    [
        (["Forthcoming", "1.10.0 (2026-01-01)", "1.9.0 (2025-01-01)"], "`1.10.0`"),
        (["Forthcoming", "0.9.0 (2025-01-01)"], "no entry for `1.0.0`"),
        (["1.1.0 (2026-01-01)", "1.0.0 (2025-01-01)"], "write `1.1.0` into package.xml"),
    ],
)
def test_changelogs_that_it_does_not_take(titles: list[str], told: str) -> None:
    ((_, message),) = said(changelog(*titles), "WSP004")
    assert told in message


def test_a_changelog_in_an_old_encoding_is_no_fault() -> None:
    files = {"package.xml": manifest(), "CHANGELOG.rst": b"1.1.0 (2026-01-01)\n---\n* \xe9\n"}
    assert lint_files(files, ["WSP004", "RPK001"]).findings == ()


def test_packages_of_one_name_for_ros_1_and_ros_2() -> None:
    ros1 = manifest("  <buildtool_depend>catkin</buildtool_depend>\n", "catkin", "my_pkg")
    files = {"ros1/a/package.xml": ros1, "ros2/a/package.xml": manifest("", "ament_cmake", "my_pkg")}
    (finding,) = lint_files(files, ["WSP001"]).findings
    assert (finding.severity.value, len(finding.related)) == ("info", 1)


@pytest.mark.parametrize(
    "folders, level",
    [
        (("src/humble/a", "src/jazzy/a"), "info"),
        (("ros2_foxy/a", "ros2_humble/a"), "info"),
        (("src/humble/a", "src/humble_copy/a"), "error"),
        (("src/humble/a", "src/main/a"), "error"),
        (("humble/src/one/a", "humble/src/two/a"), "error"),
    ],
)
def test_packages_of_one_name_for_two_distributions(folders: tuple[str, str], level: str) -> None:
    files = {f"{each}/package.xml": manifest("", "cmake", "my_pkg") for each in folders}
    (finding,) = lint_files(files, ["WSP001"]).findings
    assert finding.severity.value == level


@pytest.mark.parametrize(
    "folders, level",
    [
        (("week1/a", "week2/a"), "info"),
        (("lab_01/start/a", "lab_02/start/a"), "info"),
        (("17-publisher", "21-interfaces/a"), "info"),
        (("course/week1/a", "course/week2/b/a"), "info"),
        (("week1/a", "final/a"), "warning"),
        (("a", "a2"), "warning"),
        (("week1", "week2"), "warning"),
        (("src/week1/a", "src/week2/a"), "error"),
        (("course_ws/week1/a", "course_ws/week2/a"), "error"),
    ],
)
def test_packages_of_one_name_in_the_steps_of_a_course(folders: tuple[str, str], level: str) -> None:
    files = {f"{each}/package.xml": manifest("", "cmake", "my_pkg") for each in folders}
    (finding,) = lint_files(files, ["WSP001"]).findings
    assert finding.severity.value == level
    assert ("numbered as steps" in finding.message) == (level == "info")


@pytest.mark.parametrize(
    "folders, level",
    [
        (("exercises/day1/a", "solutions/day1/a"), "info"),
        (("ch2/start/a", "ch2/final/a"), "info"),
        (("lab1", "lab1_solution"), "info"),
        (("start", "lab"), "warning"),
        (("lab1", "lab2_solution"), "warning"),
        (("src/exercises/a", "src/solutions/a"), "error"),
    ],
)
def test_packages_of_one_name_for_a_task_and_its_solution(folders: tuple[str, str], level: str) -> None:
    files = {f"{each}/package.xml": manifest("", "cmake", "my_pkg") for each in folders}
    (finding,) = lint_files(files, ["WSP001"]).findings
    assert finding.severity.value == level
    assert ("the solution of an exercise" in finding.message) == (level == "info")


@pytest.mark.parametrize(
    "folders, level",
    [
        (("robot/a", "laptop/a"), "info"),
        (("code/raspberry_pi/a", "code/pc/b/a"), "info"),
        (("real_robot/a", "simulation/a"), "info"),
        (("robot_sim/a", "robot_real/a"), "info"),
        (("robot/a", "rover/a"), "warning"),
        (("robot_arm/a", "robot_base/a"), "warning"),
        (("robot/a", "sensors/a"), "warning"),
        (("robot", "laptop/a"), "warning"),
        (("src/robot/a", "src/laptop/a"), "error"),
    ],
)
def test_packages_of_one_name_for_a_robot_and_what_is_none(folders: tuple[str, str], level: str) -> None:
    files = {f"{each}/package.xml": manifest("", "cmake", "my_pkg") for each in folders}
    (finding,) = lint_files(files, ["WSP001"]).findings
    assert finding.severity.value == level
    assert ("each is built for itself" in finding.message) == (level == "info")


@pytest.mark.parametrize(
    ("folders", "selected", "told"),
    [
        (("one_ws/src/a", "two_ws/src/b"), "", 0),
        (("ws/src/one/a", "ws/src/two/src/b"), "", 1),
        (("src/one/src/a", "src/two/src/b"), "", 1),
        (("a", "inner/src/b"), "", 1),
        (("src/a", "inner/src/b"), "", 1),
        (("src/a", "inner/src/b"), "inner/src/b", 0),
        (("a", "inner/src/b"), "inner/src/b", 0),
        (("src/a", "inner/src/b"), "src/a", 0),
        (("ws/src/a", "ws2/src/b"), "", 0),
        (("ws/one/src/a", "ws/two/src/b"), "", 0),
        (("ws/one/src/a", "ws/one/src/b"), "", 1),
        (("ws/one/a", "ws/two/b"), "", 1),
        (("src/a", "src/b"), "src/a", 1),
        (("robot_ws/a", "server_ws/src/a"), "", 0),
        (("robot_ws/a", "robot_ws/b"), "", 1),
        (("robot/a", "server/a"), "", 1),
        (("board/extra_packages/a", "robot_ws/a"), "", 0),
    ],
)
def test_packages_of_one_name_are_told_where_one_build_finds_both(
    folders: tuple[str, str], selected: str, told: int
) -> None:
    tree = MemoryTree.of({f"{folder}/package.xml": manifest("", "cmake", "my_pkg") for folder in folders})
    scope = Scope(folders, frozenset({selected} if selected else folders))
    assert len(Session(tree, scope, frozenset({"WSP001"})).run().findings) == told


SHOW = """\
import os
from ament_index_python import get_package_share_directory
from launch_ros.actions import Node
from launch import LaunchDescription


def generate_launch_description():
    path = os.path.join(get_package_share_directory('robot'), 'urdf', '{}.yaml')
    return LaunchDescription([Node(package='x', executable='y', parameters=[path])])
"""
ROBOT = CMAKE.replace("my_pkg", "robot").replace(
    "ament_package", "install(DIRECTORY urdf DESTINATION share/${PROJECT_NAME})\nament_package"
)


@pytest.mark.parametrize(("named", "found"), [("two", []), ("one", ["LCH003"])])
def test_of_packages_of_one_name_the_nearest_is_meant(named: str, found: list[str]) -> None:
    files = {
        f"{ws}_ws/src/robot/{path}": text
        for ws in ("one", "two", "zoo")
        for path, text in {
            "package.xml": manifest("", "ament_cmake", "robot"),
            "CMakeLists.txt": ROBOT,
            f"urdf/{ws}.yaml": "",
        }.items()
    }
    files["two_ws/src/show/package.xml"] = manifest("  <exec_depend>robot</exec_depend>\n", name="show")
    files["two_ws/src/show/launch/show.launch.py"] = SHOW.format(named)
    assert [each.code for each in lint_files(files, ["LCH003"]).findings] == found
