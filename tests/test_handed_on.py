"""DEP111: what the CMake files for other packages require."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.testing import lint_files

CPP = existing_files(BACKDROPS["ament_cmake"])
REQUIRED = "find_package(std_msgs REQUIRED)\n"
USER = {
    "user/package.xml": manifest("  <depend>my_pkg</depend>\n", "ament_cmake").replace("<name>my_pkg", "<name>user"),
    "user/CMakeLists.txt": CMAKE.replace("my_pkg", "user").replace(
        "ament_package", "add_library(a a.cpp)\nament_package"
    ),
    "user/a.cpp": "int a;\n",
}
"""A package that is built with the one that is told of."""


def said(
    extras: str,
    depends: str = "",
    call: str = "CONFIG_EXTRAS cmake/x.cmake",
    path: str = "cmake/x.cmake",
    *,
    released: bool = False,
) -> list:
    cmake = CMAKE.replace("ament_package()", f"ament_package({call})")
    files = {**CPP, "CMakeLists.txt": cmake, path: extras, "package.xml": manifest(depends, "ament_cmake")}
    beside = {f"my_pkg/{path}": text for path, text in files.items()} | USER
    beside |= {"tracks.yaml": "tracks: {}\n"} if released else {}
    found = lint_files(beside, ["DEP111"]).findings
    return [(f.message.split("`")[1], f.severity.value) for f in found]


def need(name: str, tag: str) -> str:
    return f"  <{tag}>{name}</{tag}>\n"


@pytest.mark.parametrize(
    "extras, says",
    [
        (REQUIRED, True),
        ("find_package(std_msgs QUIET REQUIRED)\n", True),
        (REQUIRED * 2, True),
        ("find_package(std_msgs)\n", False),
        ("if(X)\n  find_package(std_msgs REQUIRED)\nendif()\n", False),
        ("function(x)\n  find_package(std_msgs REQUIRED)\nendfunction()\n", False),
        ("find_package(${NAME} REQUIRED)\n", False),
        ("find_package(no_such_thing REQUIRED)\n", False),
        ("find_package(my_pkg REQUIRED)\n", False),
        ("find_package(Threads REQUIRED)\n", False),
        ("find_dependency(std_msgs REQUIRED)\n", False),
        ("find_package()\nfind_package(REQUIRED)\n", False),
        ("find_package(std_msgs REQUIRED\n", False),
    ],
)
def test_what_a_file_for_others_requires(extras: str, says: bool) -> None:
    assert said(extras) == ([("std_msgs", "warning")] if says else [])


@pytest.mark.parametrize(
    "tag, level",
    [
        ("depend", ""), ("build_export_depend", ""), ("buildtool_export_depend", ""), ("build_depend", "warning"),
        ("exec_depend", "warning"), ("test_depend", "warning"), ("buildtool_depend", "warning"),
    ],
)  # fmt: skip
def test_the_tags_that_hand_it_on(tag: str, level: str) -> None:
    """rosdep installs what any tag names: where nothing is released, that is there."""
    for released in (True, False):
        told = "info" if level and not released else level
        assert said(REQUIRED, need("std_msgs", tag), released=released) == ([("std_msgs", told)] if level else [])


def test_what_brings_it() -> None:
    assert said(REQUIRED, need("sensor_msgs", "depend")) == []
    assert said(REQUIRED, need("sensor_msgs", "build_depend")) == [("std_msgs", "info")]
    assert said(REQUIRED, need("sensor_msgs", "build_depend"), released=True) == [("std_msgs", "warning")]
    assert said(REQUIRED, need("nobody_knows", "depend")) == [("std_msgs", "info")]


@pytest.mark.parametrize(
    "call, path, says",
    [
        ("CONFIG_EXTRAS_POST cmake/x.cmake", "cmake/x.cmake", True),
        ("CONFIG_EXTRAS x-extras.cmake.in", "x-extras.cmake.in", True),
        ("CONFIG_EXTRAS ${X}", "cmake/x.cmake", False),
        ("CONFIG_EXTRAS cmake/y.cmake", "cmake/x.cmake", False),
        ("", "cmake/x.cmake", False),
    ],
)
def test_which_files_are_handed_on(call: str, path: str, says: bool) -> None:
    assert bool(said(REQUIRED, "", call, path)) is says


def test_a_build_tool_is_handed_on_as_one() -> None:
    cmake = CMAKE.replace("ament_package()", "ament_package(CONFIG_EXTRAS cmake/x.cmake)")
    extras = {"cmake/x.cmake": "find_package(ament_cmake_core REQUIRED)\n"}
    files = {**CPP, "CMakeLists.txt": cmake, "package.xml": manifest("", "ament_cmake"), **extras}
    (finding,) = lint_files(files, ["DEP111"]).findings
    assert finding.message.endswith("; add <buildtool_export_depend>ament_cmake_core</buildtool_export_depend>")


@pytest.mark.parametrize(
    "name, depends, before, says",
    [
        ("nav_msgs", "", "", [("nav_msgs", "info")]),
        ("class_loader", need("acme_parts", "depend"), "", [("class_loader", "info")]),  # which may bring it
        ("class_loader", need("pluginlib", "depend"), "", []),
        ("class_loader", need("pluginlib", "test_depend"), "", [("class_loader", "info")]),  # no user gets it
        ("nav_msgs", "", "find_package(nav_msgs REQUIRED)\n", []),  # DEP104 tells of it
        ("no_such_thing", "", "", []),  # CMK117 tells of it
        ("rosidl_default_runtime", "", "", []),
        ("ament_cmake", "", "", []),
        ("my_pkg", "", "", []),
        ("Threads", "", "", []),
        ("nav_msgs", "", "if(NAV)\n", []),
    ],
)
def test_what_is_exported_and_nowhere_declared(name: str, depends: str, before: str, says: list) -> None:
    lines = f"{before}ament_export_dependencies({name})\n{'endif()' if before.startswith('if') else ''}\n"
    cmake = CMAKE.replace("ament_package()", f"{lines}ament_package()")
    files = {**CPP, "CMakeLists.txt": cmake, "package.xml": manifest(depends, "ament_cmake")}
    found = lint_files(files, ["DEP111"]).findings
    assert [(f.message.split("`")[1], f.severity.value) for f in found] == says


EXPORTED = CMAKE.replace(
    "ament_package()",
    "find_package(urdfdom_headers REQUIRED)\nament_export_dependencies(urdfdom_headers)\nament_package()",
)
BUILT = manifest(need("liburdfdom-headers-dev", "build_depend"), "ament_cmake")
FINDS = USER["user/CMakeLists.txt"].replace("add_library", "find_package(my_pkg REQUIRED)\nadd_library")
JOB = "jobs:\n  test:\n    uses: ros-industrial/industrial_ci\n    env: {PRERELEASE: true}\n"


@pytest.mark.parametrize(
    "needs, others, level",
    [
        ("", {".github/workflows/pre.yaml": JOB}, "warning"),
        ("", {"copy/.github/workflows/pre.yaml": JOB, ".git/HEAD": "x"}, "info"),
        ("", {}, "info"),
        (need("moveit_core", "depend"), {".github/workflows/pre.yaml": JOB}, "info"),
    ],
)
def test_an_export_that_only_a_release_lacks(needs: str, others: dict[str, str], level: str) -> None:
    """A job of a copy in a repository runs nowhere, and what a user declares may bring it under another name."""
    files = {**CPP, "CMakeLists.txt": EXPORTED, "package.xml": BUILT}
    own = manifest(need("my_pkg", "depend") + needs, "ament_cmake").replace("<name>my_pkg", "<name>user")
    beside = {f"copy/my_pkg/{path}": text for path, text in files.items()} | USER
    beside |= {"user/package.xml": own, "user/CMakeLists.txt": FINDS, **others}
    (found,) = lint_files(beside, ["DEP111"]).findings
    assert found.severity.value == level
