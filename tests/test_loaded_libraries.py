"""Libraries that are declared for the build alone and loaded by what is installed (DEP201)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

NODE = "find_package(yaml-cpp REQUIRED)\nadd_executable(node src/node.cpp)\n"
INSTALL = "install(TARGETS node DESTINATION lib/${PROJECT_NAME})\n"
BUILD = "  <build_depend>yaml-cpp</build_depend>\n"
LINK = "target_link_libraries(node yaml-cpp)\n"


def told(lines: str, depends: str = BUILD) -> list[tuple[str, str]]:
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{lines}ament_package()"),
        "package.xml": manifest(depends, "ament_cmake"),
        "src/node.cpp": "",
    }
    found = lint_files(files, ["DEP201"]).findings
    return [(each.severity.value, each.message.rpartition("; ")[2]) for each in found]


@pytest.mark.parametrize(
    "lines",
    [
        NODE + LINK + INSTALL,
        NODE + "target_link_libraries(node ${yaml-cpp_LIBRARIES})\n" + INSTALL,
        NODE + "target_link_libraries(node yaml-cpp::yaml-cpp)\n" + INSTALL,
        NODE.replace("add_executable(node", "add_library(node SHARED") + LINK + INSTALL,
    ],
)
def test_a_library_is_loaded_where_the_package_runs(lines: str) -> None:
    assert told(lines) == [("info", "declare it as <exec_depend>")]


@pytest.mark.parametrize(
    "lines",
    [
        NODE + LINK,
        NODE + INSTALL,
        NODE.replace("add_executable(node", "add_library(node STATIC") + LINK + INSTALL,
        f"{NODE}if(WITH_YAML)\n{LINK}endif()\n{INSTALL}",
        f"{NODE}if(BUILD_TESTING)\n{LINK}endif()\n{INSTALL}",
        NODE + "target_link_libraries(node $<$<BOOL:${X}>:yaml-cpp>)\n" + INSTALL,
        "add_library(yaml-cpp STATIC src/node.cpp)\nadd_executable(node src/node.cpp)\n" + LINK + INSTALL,
    ],
)
def test_what_is_not_certainly_loaded(lines: str) -> None:
    assert told(lines) == []


@pytest.mark.parametrize(
    "name, library, depends",
    [
        ("yaml-cpp", "yaml-cpp", "<build_depend>yaml-cpp</build_depend><exec_depend>libyaml-cpp0.8</exec_depend>"),
        ("yaml-cpp", "yaml-cpp", "<build_depend>yaml-cpp</build_depend><exec_depend>rviz_common</exec_depend>"),
        ("Eigen3", "Eigen3::Eigen", "<build_depend>eigen</build_depend>"),
        ("Boost", "Boost::headers", "<build_depend>libboost-dev</build_depend>"),
        ("tinyxml2_vendor", "tinyxml2_vendor::x", "<build_depend>tinyxml2_vendor</build_depend>"),
    ],
)
def test_headers_alone_and_what_others_bring(name: str, library: str, depends: str) -> None:
    assert told(NODE.replace("yaml-cpp", name) + f"target_link_libraries(node {library})\n" + INSTALL, depends) == []


def test_a_plain_name_and_what_may_come_with_others() -> None:
    lines = "add_executable(node src/node.cpp)\ntarget_link_libraries(node cap)\n" + INSTALL
    assert told(lines, "  <build_depend>libcap-dev</build_depend>\n") == [("info", "declare it as <exec_depend>")]
    assert told(NODE + LINK + INSTALL, BUILD + "  <depend>nobodys_package</depend>\n") == [
        ("info", "declare it as <exec_depend>")
    ]


def test_what_is_imported_is_told_by_one_rule() -> None:
    """DEP202 would say that nothing which is built uses it."""
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", "ament_python_install_package(my_pkg)\nament_package()"),
        "package.xml": manifest("  <build_depend>rclpy</build_depend>\n", "ament_cmake"),
        "my_pkg/__init__.py": "import rclpy\n",
    }
    assert [each.code for each in lint_files(files, ["DEP201", "DEP202"]).findings] == ["DEP201"]


@pytest.mark.parametrize(("required", "code"), [("", "XML208"), (" REQUIRED", "DEP104")])
def test_a_tool_for_tests_is_no_build_tool(required: str, code: str) -> None:
    tests = "if(BUILD_TESTING)\n  find_package(ament_cmake_gmock REQUIRED)\nendif()"
    lines = f"find_package(ament_cmake_ros{required})\n{tests}"
    files = {
        "CMakeLists.txt": f"cmake_minimum_required(VERSION 3.20)\nproject(my_pkg)\n{lines}\nament_package()\n",
        "package.xml": manifest(build_type="ament_cmake").replace(
            "  <buildtool_depend>ament_cmake</buildtool_depend>\n", ""
        ),
    }
    told = [each for each in lint_files(files, ["XML208", "DEP104"]).findings if "`ament_cmake_ros`" in each.message]
    assert [each.code for each in told] == [code]
