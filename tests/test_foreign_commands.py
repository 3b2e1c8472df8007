"""A macro of another package may install files: then what lacks in the share directory is unknown."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

DEFINED = "macro(make_config name)\n  message(STATUS ${name})\nendmacro()\n"
INCLUDE = '<launch>\n  <include file="$(find-pkg-share robot)/config/arm/made.launch.xml"/>\n</launch>\n'
MESH = '<robot name="r"><m f="package://robot/config/arm/made.stl"/></robot>\n'
CODES = ("CMK101", "LCH003", "URD002")


def lint(lines: str) -> tuple[set[tuple[str, str]], list[str]]:
    """Lint a robot whose CMakeLists.txt has lines, and a user of its files.

    Return code and package of what is missing, and the commands that RPK004 says are unknown.
    """
    install = "install(DIRECTORY launch urdf DESTINATION share/${PROJECT_NAME})\n"
    cmake = {name: CMAKE.replace("my_pkg", name).replace("ament_package", f"{install}ament_package")
             for name in ("robot", "user")}  # fmt: skip
    files = {
        "robot/CMakeLists.txt": cmake["robot"].replace("install(", f"{lines}\ninstall("),
        "robot/config/robot.yaml": "/**:\n  ros__parameters:\n    rate: 2.0\n",
        "user/CMakeLists.txt": cmake["user"],
    }
    for name in ("robot", "user"):
        depends = "  <exec_depend>robot</exec_depend>\n" if name == "user" else ""
        files[f"{name}/package.xml"] = manifest(depends, "ament_cmake", name)
        files[f"{name}/launch/a.launch.xml"] = INCLUDE
        files[f"{name}/urdf/a.urdf"] = MESH
    found = lint_files(files, [*CODES, "RPK004"]).findings
    unknown = [each.message.split("`")[1] for each in found if each.code == "RPK004"]
    return {(each.code, each.location.path.partition("/")[0]) for each in found if each.code != "RPK004"}, unknown


ALL = {("CMK101", "robot"), *((code, name) for code in CODES[1:] for name in ("robot", "user"))}


@pytest.mark.parametrize(
    "lines",
    ["make_config(arm)", "make_config()", "make_config(arm)\nmake_config(leg)", "if(X)\nmake_config(arm)\nendif()"],
)
def test_what_a_foreign_macro_installs_is_unknown(lines: str) -> None:
    assert lint(lines) == (set(), ["make_config"])


@pytest.mark.parametrize(
    "lines",
    [
        "",
        "make_warning_flags()",
        DEFINED + "make_config(arm)",
        "if(BUILD_TESTING)\nmake_config(arm)\nendif()",
        "set(arm leg)\nif(arm)\nmessage(STATUS arm)\nelse()\nendif()\nforeach(x a b)\nendforeach()",
        "ament_export_include_directories(include)\nqt5_wrap_cpp(moc a.hpp)\nadd_launch_test(a.py)",
        "nav2_add_gtest(a a.cpp)",
        "pkg_check_modules(zmq REQUIRED libzmq)\ncheck_cxx_compiler_flag(-Wall HAS)\npybind11_add_module(m m.cpp)",
    ],
)
def test_what_installs_nothing_there_hides_nothing(lines: str) -> None:
    assert lint(lines) == (ALL, [])


def test_several_macros_are_told_each() -> None:
    assert lint("make_config(arm)\nmake_meshes(arm)") == (set(), ["make_config", "make_meshes"])


def absent_beside(call: str, install: str = "install(DIRECTORY config launch DESTINATION share/my_pkg)") -> list[str]:
    """Return what is told of a parameter file that the folder `config` lacks, where CMake calls a foreign command."""
    launch = "<launch>\n  <let name='p' value='$(find-pkg-share my_pkg)/config/other.yaml'/>\n</launch>\n"
    files = {
        "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{install}\n{call}\nament_package"),
        "config/robot.yaml": "/**:\n  ros__parameters:\n    rate: 2.0\n",
        "launch/a.launch.xml": launch,
    }
    return [each.code for each in lint_files(files, ["LCH003"]).findings]


def test_a_folder_that_the_package_copies_whole_is_known_beside_a_command_that_names_neither_it_nor_a_place() -> None:
    assert absent_beside("make_parameters(src/parameters.yml)") == ["LCH003"]


@pytest.mark.parametrize(
    "call",
    [
        "make_parameters(config/arm.yml)",
        "make_parameters(arm.yml DESTINATION share/my_pkg)",
        "install_parameters(arm.yml)",
        "my_package(arm)",
    ],
)
def test_a_command_that_may_fill_the_folder_leaves_it_unknown(call: str) -> None:
    assert not absent_beside(call)


def test_a_folder_of_which_only_some_files_are_installed_is_unknown() -> None:
    assert not absent_beside("make_parameters(arm.yml)", "install(FILES config/robot.yaml DESTINATION share/my_pkg)")
