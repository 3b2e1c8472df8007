"""DEP001 and DEP203: what is certain of a name, also where packages of the workspace are not here."""

from __future__ import annotations

import pytest
from test_fetched_names import INDEX, need

from rospkg_cli.checks.depends.similar_names import SimilarNames
from rospkg_cli.engine.discovery.incomplete_workspace import MissingPackages, missing_packages
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.example import BACKDROPS, existing_files, manifest
from rospkg_cli.finding import Finding
from rospkg_cli.package.missing_repositories import may_hold
from rospkg_cli.package.package_facts import ActiveDependency, PackageFacts
from rospkg_cli.package.workspace import Workspace
from rospkg_cli.ros.distros import Targets
from rospkg_cli.ros.name_index import dump
from rospkg_cli.ros.names import BUILT_IN, FetchedNames
from rospkg_cli.tree import MemoryTree

COMPLETE = MissingPackages()
UNNAMED = MissingPackages("the list can't be read")
NAMED = MissingPackages("`a.repos` lists repositories that are not here", frozenset({"src/gripper_ros", "navigation2"}))


def lint(body: str, missing: MissingPackages = COMPLETE, codes: str = "DEP001", fetched: bool = False) -> list[Finding]:
    index = FetchedNames(dump(INDEX)) if fetched else BUILT_IN
    names = {"index": index, "missing_repositories": missing.repositories}
    scope = Scope(("",), frozenset({""}), "my_pkg", missing.why, **names)
    files = existing_files({**BACKDROPS["ament_python"], "package.xml": manifest(body)})
    return list(Session(MemoryTree.of(files), scope, frozenset({codes}), Targets()).run().findings)


def said(name: str, *arguments: object) -> list[tuple[str, str]]:
    """Return the level, and what is wrong, of each finding about a name."""
    return [(f.severity.value, f.message.partition(":")[0]) for f in lint(need(name), *arguments)]


@pytest.mark.parametrize("missing", [COMPLETE, UNNAMED, NAMED])
@pytest.mark.parametrize(
    "name, wrong, meant",
    [
        ("python-serial", "is a key of Python 2", "python3-serial"),
        ("python-crypto-x", "", ""),
        ("python-pyyaml", "is a key of Python 2", "python3-yaml"),
        ("python-transforms3d", "is a key of Python 2", "python3-transforms3d"),
        ("python3-pyserial", "is no rosdep key", "python3-serial"),
        ("cv2", "is what Python imports", "python3-opencv"),
        ("rclpy.qos", "is a module", "rclpy"),
        ("no_such.qos", "", ""),
        ("rosidl-default-generators", "is no known ROS package or rosdep key", "rosidl_default_generators"),
        ("yaml_cpp", "is no known ROS package or rosdep key", "yaml-cpp"),
        ("Nav2_Util", "is no known ROS package or rosdep key", "nav2_util"),
        ("nav2_utils", "is no known ROS package or rosdep key", "nav2_util"),
        ("python3-nmupy", "is no known ROS package or rosdep key", "python3-numpy"),
        ("std_svrs", "is no known ROS package or rosdep key", "std_srvs"),
        ("acl_x", "", ""),
        ("ubr_msgs", "", ""),
    ],
)
def test_what_is_certain_without_an_index(missing: MissingPackages, name: str, wrong: str, meant: str) -> None:
    (found,) = lint(need(name), missing) or [None]
    assert (found is None) is (not wrong)
    if found is not None:
        assert found.severity.value == "warning"
        assert f"`{name}` {wrong}: " in found.message
        assert found.fix is not None
        assert [edit.text for edit in found.fix.operations] == [meant]


def test_a_key_of_python_2_without_a_rule_has_another_error() -> None:
    (found,) = lint(need("python-crypto"))[:1] or [None]
    assert found is None
    (found,) = lint(need("python-cairo"))
    assert '"No definition of [python-cairo] for OS version [jammy]"; write `python3-cairo`' in found.message
    (found,) = lint(need("python-opencv"))
    assert '"E: Unable to locate package python-opencv"; write `python3-opencv`' in found.message
    assert not lint(need("python-is-python3"))
    (found,) = lint(need("python-serial"))
    assert "Cannot locate rosdep definition for [python-serial]" in found.message


def test_a_module_is_no_name_for_cpp() -> None:
    files = {"package.xml": manifest("  <depend>cv2</depend>\n", "ament_cmake"), "CMakeLists.txt": ""}
    session = Session(MemoryTree.of(files), Scope(("",), frozenset({""})), frozenset({"DEP001"}), Targets())
    assert session.run().findings == ()


@pytest.mark.parametrize(
    "name", ["std_msgs, rclpy", "std_msgs rclpy", "std_msgs,rclpy", "\n    std_msgs\n    rclpy\n  "]
)
def test_two_names_in_one_tag_become_two_tags(name: str) -> None:
    (found,) = lint(f'  <exec_depend condition="$ROS_VERSION == 2">{name}</exec_depend>\n')
    assert "is 2 names in one tag" in found.message
    assert found.message.endswith("write <exec_depend>std_msgs</exec_depend> <exec_depend>rclpy</exec_depend>")
    assert found.fix is not None
    lines = found.fix.operations[0].text.split("\n  ")
    assert lines == [
        f'<exec_depend condition="$ROS_VERSION == 2">{each}</exec_depend>' for each in ("std_msgs", "rclpy")
    ]


@pytest.mark.parametrize(
    "name, missing, level",
    [
        ("my_companys_driver", COMPLETE, ["warning"]),
        ("my_companys_driver", UNNAMED, []),
        ("my_companys_driver", NAMED, ["info"]),
        ("gripper_driver", NAMED, []),
        ("nav2_wheels", NAMED, []),
        ("robot_msgs", NAMED, []),
        ("libwheel-dev", NAMED, ["warning"]),
        ("libwheel-dev", UNNAMED, ["warning"]),
        ("libgripper2-dev", NAMED, ["warning"]),
        ("acme.wheel", UNNAMED, ["warning"]),
        ("python3-wheel-acme", UNNAMED, ["warning"]),
        ("libwheel", UNNAMED, []),
        ("weel_odometry", UNNAMED, ["warning"]),
        ("wheell_odometrry", UNNAMED, ["warning"]),
        ("wheell_odometrry", COMPLETE, ["warning"]),
        ("only_in_humble", NAMED, []),
    ],
)
def test_unknown_names_of_a_fetched_index(name: str, missing: MissingPackages, level: list[str]) -> None:
    assert [each for each, _ in said(name, missing, "DEP001", True)] == level


def test_what_to_do_where_a_repository_may_have_it() -> None:
    (found,) = lint(need("my_companys_driver"), NAMED, fetched=True)
    assert found.message.endswith(
        "; no listed repository that is missing here is called like it: is it in one of them?"
    )


def test_what_to_do_with_a_name_that_nobody_has() -> None:
    (found,) = lint(need("my_companys_driver"), fetched=True)
    assert found.message.endswith("; is it a package that the workspace lacks?")


@pytest.mark.parametrize(
    "name, missing, level",
    [
        ("rosserial_python", COMPLETE, ["info"]),
        ("rosserial_python", NAMED, ["info"]),
        ("rosserial_python", UNNAMED, []),
        ("navigation_stage", NAMED, []),
        ("rospy", NAMED, ["warning"]),
        ("gmapping", UNNAMED, ["warning"]),
    ],
)
def test_what_only_ros_1_had(name: str, missing: MissingPackages, level: list[str]) -> None:
    found = lint(need(name), missing, "DEP203")
    assert [each.severity.value for each in found] == level
    assert lint(need(name), missing, "DEP001", fetched=True) == []


def test_a_name_on_pypi_is_that_and_no_package_of_ros_1() -> None:
    assert lint(need("serial"), codes="DEP203") == []
    assert [f.message.partition(":")[0] for f in lint(need("serial"))] == ["`serial` is its name on PyPI"]
    files = {"package.xml": manifest("  <depend>serial</depend>\n", "ament_cmake"), "CMakeLists.txt": ""}
    codes = frozenset({"DEP001", "DEP203"})
    (found,) = Session(MemoryTree.of(files), Scope(("",), frozenset({""})), codes, Targets()).run().findings
    assert found.message.startswith("`serial` was released for ROS 1 only (last for noetic): ")
    assert found.message.endswith("; replace it, or put a port of it into the workspace")


def test_what_only_a_variable_asks_for_is_an_info() -> None:
    levels = [f.severity.value for f in lint(need("my_companys_driver", "$OURS == 1"), fetched=True)]
    assert levels == ["info"]
    both = need("my_companys_driver", "$OURS == 1") + need("my_companys_driver")
    assert [f.severity.value for f in lint(both, fetched=True)] == ["warning"]
    assert [f.severity.value for f in lint(need("std_msg", "$OURS == 1"))] == ["info"]


def test_a_package_of_ros_1_that_is_here_was_ported() -> None:
    files = {"a/package.xml": manifest(need("rosserial_python"), name="a"), "a/setup.py": ""}
    files |= {"b/package.xml": manifest(name="rosserial_python"), "b/setup.py": ""}
    scope = Scope(("a", "b"), frozenset({"a"}))
    assert Session(MemoryTree.of(files), scope, frozenset({"DEP001", "DEP203"}), Targets()).run().findings == ()


def workspace(*names: str, needs: str = "") -> SimilarNames:
    facts = [PackageFacts(name, name) for name in names]
    user = PackageFacts("user", "user", dependencies=(ActiveDependency("depend", needs),) if needs else ())
    return SimilarNames(Workspace((*facts, user)))


def test_a_renamed_package_of_the_workspace() -> None:
    """It shares its last words with one package alone, which nobody needs by its new name."""
    assert workspace("acme_wheel_planner", "acme_base").renamed("old_wheel_planner") == "acme_wheel_planner"
    assert workspace("acme_planner", "acme_base").renamed("old_planner") == "acme_planner"
    assert workspace("acme_planner", "acme_base", needs="acme_planner").renamed("old_planner") is None
    assert workspace("acme_planner", "b_planner").renamed("old_planner") is None
    assert workspace("acme_msgs").renamed("old_msgs") is None
    assert workspace("acme_arm").renamed("old_arm") is None
    assert workspace("acme_base").renamed("old_planner") is None


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("sensor_mgs", "sensor_msgs"),
        ("libpcl-ll-dev", "libpcl-all-dev"),
        ("diagnostic_mgss", "diagnostic_msgs"),
        ("sensor_mags", None),
        ("tf2_rso", None),
        ("depth_image_proz", None),
    ],
)
def test_letters_lost_or_swapped_in_a_short_word_of_a_long_name(name: str, meant: str | None) -> None:
    assert workspace().intended(name) == meant


def test_names_of_the_workspace_come_first() -> None:
    assert workspace("acme_driver", "acme_base").intended("acme-driver") == "acme_driver"
    assert workspace("acme_driver", "acme_base").intended("acme_drivr") == "acme_driver"
    assert workspace("nav2_utill").intended("nav2_utils") == "nav2_utill"
    assert workspace("nav2_utilities").intended("nav2_utils") == "nav2_util"
    assert workspace("acme_left", "acme_lefts").intended("acme_leftt") is None
    assert workspace("ab_c").intended("ab-c") is None


@pytest.mark.parametrize(
    "repositories, package, may",
    [
        (["a/gripper"], "gripper_driver", True),
        (["vendor/ros2_gripper2"], "my_grippers", True),
        (["gripper/tools"], "gripper_driver", False),
        (["navigation2"], "nav2_x", True),
        (["na"], "nav2_x", False),
        (["na2"], "nav2_x", False),
        (["go2_ros"], "go2_rviz", True),
        (["go2_ros"], "go3_rviz", False),
        (["ros2_base"], "ros2_wheel", False),
        (["wheel_driver"], "gripper_driver", False),
        (["anything"], "robot_msgs", True),
        (["robotiq"], "robot_arm", False),
        ([], "gripper", False),
    ],
)
def test_repositories_by_name(repositories: list[str], package: str, may: bool) -> None:
    assert may_hold(repositories, package) is may


def test_the_names_of_all_that_is_missing(tmp_path, write) -> None:
    lists = {"a.repos": "repositories:\n  arm: {type: git}\n", ".gitmodules": '[submodule "x"]\n\tpath = src/x\n'}
    write(tmp_path, {"pkg/package.xml": "", **lists})
    assert missing_packages(tmp_path, [tmp_path / "pkg"]).repositories == {"arm", "src/x"}
    write(tmp_path, {"b.repos": "- [\n"})
    found = missing_packages(tmp_path, [tmp_path / "pkg"])
    assert (bool(found.why), found.repositories) == (True, frozenset())
