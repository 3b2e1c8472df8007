"""Macros from outside of a package, which may compile sources and register components (LCH011, CMK108, CMK202)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.rules.cmake import cmk202_uncompiled_source as cmk202
from rospkg_cli.rules.launch import lch011_unknown_component as lch011
from rospkg_cli.testing import lint_files

REGISTER = 'rclcpp_components_register_nodes(talker "my_pkg::Talker")\n'
OTHERS = (
    "include(${CMAKE_CURRENT_SOURCE_DIR}/../cmake/common.cmake)\n",
    "include(${CORP_ROOT}/common.cmake)\n",
    "find_package(corp_cmake REQUIRED)\ncorp_component(health SRC src/health.cpp CLASS corp::Health)\n",
    "find_package(corp_cmake REQUIRED)\ncorp_components()\n",
)


def lint(name: str, more: str) -> list[str]:
    """Return the levels of what is said of a class that a launch file loads."""
    cmake = lch011.FILES["CMakeLists.txt"].replace(REGISTER, REGISTER + more)
    launch = lch011.BAD.replace("«my_pkg::Taker»", name)
    files = {**lch011.FILES, "CMakeLists.txt": cmake, "launch/a.launch.xml": launch}
    return [each.severity.value for each in lint_files(files, ["LCH011"]).findings]


@pytest.mark.parametrize("more", OTHERS)
def test_what_a_macro_from_outside_may_register_is_left_alone(more: str) -> None:
    assert lint("corp::Health", more) == []


@pytest.mark.parametrize("more", OTHERS)
def test_a_slip_of_a_registered_name_is_told_beside_any_macro(more: str) -> None:
    assert lint("my_pkg::Tallker", more) == ["error"]


FETCHED = "include(FetchContent)\nFetchContent_Declare(json URL a)\nFetchContent_MakeAvailable(json)\n"
OPTIONS = ["", "nav2_package()\n", "append_coverage_compiler_flags()\n", "set_options()\n"]


@pytest.mark.parametrize("more", [*OPTIONS, FETCHED, "add_subdirectory(third_party/json)\n"])
def test_what_only_sets_options_registers_nothing(more: str) -> None:
    assert lint("corp::Health", more) == ["error"]


@pytest.mark.parametrize(("more", "count"), [("corp_components()\n", 0), ("nav2_package()\n", 1)])
def test_a_macro_that_is_given_nothing_may_compile_what_it_finds(more: str, count: int) -> None:
    bad = {
        name: text.replace("«", "").replace("»", "") for name, text in cmk202.uncompiled_source.examples[0].bad.items()
    }
    files = {**bad, "CMakeLists.txt": bad["CMakeLists.txt"].replace("ament_package", f"{more}ament_package")}
    assert len(lint_files(files, ["CMK202"]).findings) == count


GIVEN = (
    'corp_register(drive PLUGIN "corp::Drive" EXECUTABLE drive_node)\n',
    "corp_register(drive corp::Wheel corp::Drive)\n",
    'corp_register(drive PLUGINS "corp::Wheel;corp::Drive")\n',
    'set(PARTS "corp::Drive")\ncorp_register(drive ${PARTS})\n',
    'function(own name)\n  corp_register(drive PLUGIN "${name}")\nendfunction()\nown("corp::Drive")\n',
    'if(CORP_PARTS)\n  corp_register(drive PLUGIN "corp::Drive")\nendif()\n',
)
NOT_GIVEN = (
    "",
    'corp_register(drive PLUGIN "corp::Wheel" EXECUTABLE drive_node)\n',
    'corp_register(drive PLUGIN "corp::Drives")\n',
    'message(STATUS "corp::Drive")\n',
    'if(BUILD_TESTING)\n  corp_try(drive PLUGIN "corp::Drive")\nendif()\n',
    'function(own_register name)\nendfunction()\nown_register("corp::Drive")\n',
)


def unregistered(lines: str, more: dict[str, str] | None = None) -> list[str]:
    """Return the levels of what is said of a class that a source registers and that no command of ROS does."""
    library = "add_library(drive SHARED src/drive.cpp)\ninstall(TARGETS drive DESTINATION lib)\n"
    body = f"find_package(rclcpp_components REQUIRED)\nfind_package(corp_cmake REQUIRED)\n{library}{lines}ament_package"
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package", body),
        "package.xml": manifest("  <depend>rclcpp_components</depend>\n", "ament_cmake"),
        "src/drive.cpp": "RCLCPP_COMPONENTS_REGISTER_NODE(corp::Drive)\n",
        **(more or {}),
    }
    return [each.severity.value for each in lint_files(files, ["CMK108"]).findings]


@pytest.mark.parametrize("lines", GIVEN)
def test_a_class_that_a_macro_from_outside_is_given_may_be_registered_by_it(lines: str) -> None:
    assert unregistered(lines) == []


@pytest.mark.parametrize("lines", NOT_GIVEN)
def test_a_class_that_no_macro_from_outside_is_given_stays_a_warning(lines: str) -> None:
    assert unregistered(lines) == ["warning"]


def test_a_class_that_a_launch_file_loads_and_no_macro_is_given_stays_an_error() -> None:
    launch = lch011.BAD.replace("«my_pkg::Taker»", "corp::Drive")
    assert unregistered(NOT_GIVEN[1], {"launch/a.launch.xml": launch}) == ["error"]
    assert unregistered(GIVEN[0], {"launch/a.launch.xml": launch}) == []
