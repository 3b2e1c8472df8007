"""DEP205 and DEP204: what a metapackage leaves out, and what only tests use."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.testing import lint_files

REPOSITORY = {".github/workflows/build.yml": "on: push\n"}
NAMED = ("arm", "base", "camera", "driver")
PYTHON = existing_files(BACKDROPS["ament_python"])
CPP = existing_files(BACKDROPS["ament_cmake"])


def package(name: str, body: str = "") -> dict[str, str]:
    return {f"{name}/package.xml": manifest(body, "ament_cmake", name), f"{name}/CMakeLists.txt": CMAKE}


def left_out(*others: dict[str, str], names: tuple[str, ...] = NAMED) -> list[str]:
    body = "".join(f"  <exec_depend>{name}</exec_depend>\n" for name in names)
    files = REPOSITORY | package("robot", body)
    for each in (*(package(name) for name in NAMED), *others):
        files |= each
    return [finding.message.split("`")[1] for finding in lint_files(files, ["DEP205"]).findings]


def test_a_metapackage_that_leaves_one_out() -> None:
    assert left_out(package("lidar")) == ["lidar"]
    assert left_out() == []


@pytest.mark.parametrize(
    "other",
    [
        package("robot_tests"),
        package("robot_examples"),
        package("simulation", "  <exec_depend>robot</exec_depend>\n"),
        package("tools", "  <exec_depend>arm</exec_depend>\n"),
    ],
)
def test_what_a_metapackage_need_not_name(other: dict[str, str]) -> None:
    assert left_out(other) == []


def test_a_metapackage_in_python() -> None:
    body = "".join(f"  <exec_depend>{name}</exec_depend>\n" for name in NAMED)
    own = {path.replace("my_pkg", "robot"): text.replace("my_pkg", "robot") for path, text in PYTHON.items()}
    own = {f"robot/{path}": text for path, text in own.items()} | {"robot/package.xml": manifest(body, name="robot")}
    assert left_out(package("lidar"), own) == ["lidar"]
    assert left_out(package("lidar"), own | {"robot/robot/talker.py": "print(1)\n"}) == []


def test_what_comes_with_a_named_package() -> None:
    assert left_out(package("lidar"), package("arm", "  <depend>lidar</depend>\n")) == []


def test_a_metapackage_of_a_part_of_the_repository() -> None:
    assert left_out(package("lidar"), package("sonar"), package("radar")) == []
    assert left_out(package("lidar"), names=NAMED[:3]) == []


def of_family(names: str, *others: str, own: str = "acme", body: str = "") -> list[str]:
    """Return what is told of a package that names some of the others of its repository, which have a header each."""
    body += "".join(f"  <depend>{name}</depend>\n" for name in names.split())
    files = REPOSITORY | package(own, body)
    for name in others:
        files |= package(name) | {f"{name}/include/{name}/{name}.hpp": "#pragma once\n"}
    return [finding.message.partition(" not named")[0] for finding in lint_files(files, ["DEP205"]).findings]


def test_the_only_metapackage_of_a_family() -> None:
    assert of_family("acme_arm", "acme_arm", "acme_base") == ["`acme_base` is"]
    assert of_family("acme_arm", "acme_arm", "acme_base", "acme_cam", "acme_tf") == [
        "`acme_base` is", "`acme_cam` is", "`acme_tf` is",
    ]  # fmt: skip
    lacking = ["`acme_base`, `acme_cam`, `acme_lidar` and `acme_tf` are"]
    assert of_family("acme_arm", "acme_arm", "acme_base", "acme_cam", "acme_lidar", "acme_tf") == lacking
    assert of_family("acme_arm", "acme_arm", "acme_base", "acme_cam", "other") == [
        "`acme_base` is", "`acme_cam` is", "`other` is",
    ]  # fmt: skip


def test_what_is_no_metapackage_of_a_family() -> None:
    assert of_family("acme_arm", "acme_arm") == []
    assert of_family("acme_arm", "acme_arm", "acme_base", "other") == []
    assert left_out(package("robot_desktop", "  <depend>arm</depend>\n"), package("robot_base"), names=("arm",)) == []


def test_an_empty_package_that_names_nothing() -> None:
    family = ("acme_arm", "acme_base", "acme_cam")
    lacking = ["`acme_arm` is", "`acme_base` is", "`acme_cam` is"]
    assert of_family("", *family) == lacking
    assert of_family("", *family, body="  <test_depend>ament_lint_auto</test_depend>\n") == lacking
    assert of_family("", *family[:2]) == []
    assert of_family("", *family, "other") == []
    assert of_family("", *family, body="  <exec_depend>rclcpp</exec_depend>\n") == []
    assert of_family("", *family, own="acme_driver") == []
    assert lint_files(REPOSITORY | package("acme") | package("acme_arm") | package("acme_a"), ["DEP205"]).findings == ()


def messages(name: str, body: str = "") -> dict[str, str]:
    generated = (
        "find_package(rosidl_default_generators REQUIRED)\nrosidl_generate_interfaces(${PROJECT_NAME} msg/A.msg)\n"
    )
    files = package(name, body)
    lists = files[f"{name}/CMakeLists.txt"].replace("ament_package", f"{generated}ament_package")
    return files | {f"{name}/CMakeLists.txt": lists.replace("my_pkg", name), f"{name}/msg/A.msg": "bool a\n"}


@pytest.mark.parametrize("tag, found", [("exec_depend", ["a_msgs"]), ("depend", [])])
def test_a_package_of_messages_that_names_its_siblings(tag: str, found: list[str]) -> None:
    names = ("b_msgs", "c_msgs", "d_msgs", "e_msgs")
    body = "".join(f"  <{tag}>{name}</{tag}>\n" for name in names)
    files = REPOSITORY | messages("all_msgs", body) | messages("a_msgs")
    for name in names:
        files |= messages(name)
    assert [each.message.split("`")[1] for each in lint_files(files, ["DEP205"]).findings] == found
    assert lint_files(files | package("other"), ["DEP205"]).findings == ()


def only_tests(files: dict[str, str]) -> list[str]:
    return [finding.message.split("`")[1] for finding in lint_files(files, ["DEP204"]).findings]


@pytest.mark.parametrize("tag, found", [("depend", ["nav_msgs"]), ("exec_depend", ["nav_msgs"]), ("test_depend", [])])
def test_what_tests_alone_import(tag: str, found: list[str]) -> None:
    files = {
        **PYTHON,
        "package.xml": manifest(f"  <{tag}>nav_msgs</{tag}>\n"),
        "test/test_a.py": "import nav_msgs.msg\n",
    }
    assert only_tests(files) == found
    assert only_tests({**files, "my_pkg/node.py": "import nav_msgs.msg\n"}) == []
    assert only_tests({**files, "launch/a.launch.xml": "<launch><node pkg='nav_msgs' exec='x'/></launch>\n"}) == []


def test_what_reads_launch_files_is_named_in_none() -> None:
    files = {**PYTHON, "package.xml": manifest("  <exec_depend>launch_ros</exec_depend>\n")}
    files["test/test_launch.py"] = "from launch_ros.substitutions import FindPackageShare\n"
    assert only_tests({**files, "launch/a.launch.xml": "<launch><node pkg='my_pkg' exec='x'/></launch>\n"}) == []


def test_what_cmake_looks_for_in_tests_alone() -> None:
    testing = "if(BUILD_TESTING)\n  find_package(nav_msgs REQUIRED)\nendif()\n"
    files = {**CPP, "package.xml": manifest("  <depend>nav_msgs</depend>\n", "ament_cmake")}
    files["CMakeLists.txt"] = CMAKE.replace("ament_package()", f"{testing}ament_package()")
    assert only_tests(files) == ["nav_msgs"]
    assert only_tests({**files, "src/node.cpp": "#include <nav_msgs/msg/odometry.hpp>\n"}) == []
    assert only_tests({**files, "README.md": "It shows nav_msgs.\n"}) == []
    node = {"package.xml": manifest("  <exec_depend>nav_msgs</exec_depend>\n", "ament_cmake")}
    assert only_tests({**files, **node}) == []
