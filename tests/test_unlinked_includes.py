"""Headers of packages that a target is not linked with (CMK121): what brings them, and what is not known."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

NAMES = ("rclcpp", "sensor_msgs", "tf2_ros", "cv_bridge")
FINDS = "".join(f"find_package({name} REQUIRED)\n" for name in NAMES)
NEEDS = "".join(f"  <depend>{name}</depend>\n" for name in NAMES)
NODE = "add_executable(node src/node.cpp)\n"
IMAGE, BUFFER = "#include <sensor_msgs/msg/image.hpp>\n", "#include <tf2_ros/buffer.h>\n"


def told(lines: str, source: str = IMAGE, **files: str) -> list[tuple[str, str]]:
    """Return level and header of each include that a target is not linked with."""
    written = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{FINDS}{lines}ament_package()"),
        "package.xml": manifest(NEEDS, "ament_cmake"),
        "src/node.cpp": source,
        **files,
    }
    return [(f.severity.value, f.message.split("`")[1]) for f in lint_files(written, ["CMK121"]).findings]


@pytest.mark.parametrize(
    "lines",
    [
        NODE,
        f"{NODE}target_link_libraries(node rclcpp::rclcpp pthread yaml-cpp Eigen3::Eigen)\n",
        f"{NODE}ament_target_dependencies(node rclcpp)\n",
        f"add_library(sensing SHARED src/part.cpp)\n{NODE}target_link_libraries(node usb-1.0)\n",
        "add_library(part SHARED src/part.cpp)\ntarget_link_libraries(part PRIVATE ${sensor_msgs_TARGETS})\n"
        f"{NODE}target_link_libraries(node part)\n",
        f"include_directories(BEFORE include ${{Boost_INCLUDE_DIRS}})\n{NODE}",
        f"include_directories(${{rclcpp_INCLUDE_DIRS}} ${{YAML_CPP_INCLUDEDIR}} ${{ament_INCLUDE_DIRS}})\n{NODE}",
        f"pkg_check_modules(CAER REQUIRED libcaer)\ninclude_directories(${{CAER_INCLUDE_DIRS}})\n{NODE}",
        f"find_library(RML_LIB rml)\n{NODE}target_link_libraries(node ${{RML_LIB}} ${{YAML_CPP_LIBRARIES}})\n",
        f"{NODE}target_include_directories(node PRIVATE ${{EIGEN3_INCLUDE_DIR}} ${{rclcpp_INCLUDE_DIRS}})\n",
        f"if(BUILD_TESTING)\n  {NODE}endif()\n",
        "if(BUILD_TESTING)\n  ament_add_gtest(node src/node.cpp TIMEOUT 60)\n"
        "  if(TARGET node)\n    target_link_libraries(node rclcpp::rclcpp)\n  endif()\nendif()\n",
    ],
)
def test_a_target_needs_what_it_includes(lines: str) -> None:
    assert told(lines) == [("warning", "sensor_msgs/msg/image.hpp")]
    assert told(lines, BUFFER) == [("info", "tf2_ros/buffer.h")]


@pytest.mark.parametrize(
    "lines",
    [
        f"{NODE}target_link_libraries(node ${{sensor_msgs_TARGETS}})\n",
        f"{NODE}target_link_libraries(node cv_bridge::cv_bridge)\n",
        f"{NODE}ament_target_dependencies(node PUBLIC sensor_msgs)\n",
        "add_library(part SHARED src/part.cpp)\ntarget_link_libraries(part PUBLIC ${sensor_msgs_TARGETS})\n"
        f"{NODE}target_link_libraries(node part)\n",
        f"{NODE}target_link_libraries(node nobodys::lib)\n",
        f"add_library(sensing SHARED src/part.cpp)\n{NODE}target_link_libraries(node sensnig)\n",
        f"{NODE}ament_target_dependencies(node nobodys)\n",
        f"{NODE}target_link_libraries(node ${{MORE}} $<TARGET_OBJECTS:x>)\n",
        f"{NODE}target_include_directories(node PRIVATE ${{sensor_msgs_INCLUDE_DIRS}})\n",
        f"{NODE}include_directories(/opt/x)\n",
        f"{NODE}include_directories(${{sensor_msgs_INCLUDE_DIRS}})\n",
        "add_library(part SHARED src/part.cpp)\n"
        "target_include_directories(part PUBLIC ${sensor_msgs_INCLUDE_DIRS})\n"
        f"{NODE}target_link_libraries(node part)\n",
        f"{NODE}target_include_directories(node PRIVATE /opt/ros/jazzy/include/sensor_msgs)\n",
        "if(BUILD_TESTING)\n  ament_add_gtest(node src/node.cpp)\n  if(TARGET node)\n"
        "    target_link_libraries(node sensor_msgs::sensor_msgs)\n  endif()\nendif()\n",
        f"{NODE}include_directories(${{MORE}})\n",
        f"{NODE}link_libraries(sensor_msgs::sensor_msgs)\n",
        "ament_auto_add_executable(node src/node.cpp)\n",
        f"if(WITH_NODE)\n  {NODE}endif()\n",
    ],
)
def test_what_another_way_brings_or_nobody_knows(lines: str) -> None:
    assert told(lines) == []


def test_what_is_included_in_any_case() -> None:
    assert told(NODE, '#include "my_pkg/node.hpp"\n', **{"include/my_pkg/node.hpp": IMAGE}) != []
    assert told(NODE, f"#ifdef WITH_IMAGE\n{IMAGE}#endif\n") == []
    assert told(NODE, "#include <nav_msgs/msg/odometry.hpp>\n") == []
    assert told(f"{NODE}add_executable(other src/other.cpp)\n", **{"src/other.cpp": IMAGE}) == [
        ("warning", "sensor_msgs/msg/image.hpp")
    ]


INDEX = "#include <ament_index_cpp/get_package_share_directory.hpp>\n"


@pytest.mark.parametrize(
    "links, levels",
    [
        ("rclcpp::rclcpp", ["warning"]),
        ("rclcpp::rclcpp ${{acme_msgs_TARGETS}}", ["warning"]),
        ("rclcpp::rclcpp tf2_ros::tf2_ros", ["warning"]),
        ("rclcpp::rclcpp pluginlib::pluginlib", []),
        ("ament_index_cpp::ament_index_cpp", []),
        ("yaml-cpp", []),
    ],
)
def test_what_rclcpp_keeps_to_itself_from_jazzy_on(links: str, levels: list[str]) -> None:
    lines = f"{NODE}target_link_libraries(node {links.format()})\n"
    found = told(lines, INDEX, **{"README.md": "For Humble and Jazzy.\n"})
    assert [level for level, _ in found] == levels
    for page in ("", "For Humble.\n"):
        milder = told(lines, INDEX, **{"README.md": page})
        assert [level for level, _ in milder] == ["info" for _ in levels]


def test_packages_that_nobody_knows() -> None:
    """Those of interfaces bring interfaces alone; folders of others may hold anything."""
    acme = f"{NODE}ament_target_dependencies(node rclcpp acme_msgs)\n"
    assert told(acme, INDEX, **{"README.md": "For Jazzy.\n"}) == [
        ("warning", "ament_index_cpp/get_package_share_directory.hpp")
    ]
    assert told(acme) == [("info", "sensor_msgs")]
    assert told(f"{NODE}include_directories(${{nobodys_INCLUDE_DIRS}})\n") == [("info", "sensor_msgs")]


def test_what_comes_on_some_distributions_alone() -> None:
    found = "find_package(image_transport REQUIRED)\nfind_package(rclcpp_components REQUIRED)\n"
    lines = f"{found}{NODE}ament_target_dependencies(node image_transport)\n"
    assert told(lines, "#include <rclcpp_components/register_node_macro.hpp>\n") == [("info", "rclcpp_components")]


BASE = "src/acme_base/"
PASSED = "find_package(rclcpp REQUIRED)\nfind_package(sensor_msgs REQUIRED)\nadd_library(base SHARED src/base.cpp)\n"


def told_beside(lines: str) -> list[str]:
    """Return the levels for a node that is linked with a package of the workspace, whose CMake has some lines."""
    node = f"find_package(acme_base REQUIRED)\n{FINDS}{NODE}target_link_libraries(node acme_base::base)\n"
    written = {
        f"{BASE}package.xml": manifest("  <depend>rclcpp</depend>\n  <depend>sensor_msgs</depend>\n", "ament_cmake"),
        f"{BASE}CMakeLists.txt": CMAKE.replace("ament_package()", f"{PASSED}{lines}ament_package()"),
        "src/node/package.xml": manifest(f"  <depend>acme_base</depend>\n{NEEDS}", "ament_cmake", "node"),
        "src/node/CMakeLists.txt": CMAKE.replace("my_pkg", "node").replace("ament_package()", f"{node}ament_package()"),
        "src/node/src/node.cpp": IMAGE,
    }
    files = {path: text.replace("my_pkg", "acme_base") for path, text in written.items()}
    return [each.severity.value for each in lint_files(files, ["CMK121"]).findings]


@pytest.mark.parametrize(
    "lines",
    [
        "target_link_libraries(base PUBLIC rclcpp::rclcpp PRIVATE sensor_msgs::sensor_msgs)\n",
        "add_executable(other src/other.cpp)\nament_target_dependencies(other sensor_msgs)\n",
        "target_include_directories(base PUBLIC ${sensor_msgs_INCLUDE_DIRS})\nament_export_libraries(base)\n",
        "find_library(QP qp)\ntarget_link_libraries(base ${QP})\n",
    ],
)
def test_what_a_package_of_the_workspace_keeps_to_itself(lines: str) -> None:
    assert told_beside(lines) == ["warning"]


@pytest.mark.parametrize(
    "lines",
    [
        "target_link_libraries(base PUBLIC ${sensor_msgs_TARGETS})\n",
        "ament_target_dependencies(base sensor_msgs)\n",
        "ament_export_dependencies(sensor_msgs)\n",
        "ament_export_dependencies(${MORE})\n",
        "target_link_libraries(base ${MORE})\n",
        "acme_export(sensor_msgs)\n",
        "ament_package(CONFIG_EXTRAS extras.cmake)\n",
        "generate_parameter_library(parameters src/parameters.yaml)\n",
    ],
)
def test_what_a_package_of_the_workspace_hands_on_or_nobody_knows(lines: str) -> None:
    assert told_beside(lines) == []


@pytest.mark.parametrize(
    ("more", "count"),
    [
        ("", 1),
        ("include_directories(${YAML_CPP_INCLUDE_DIR})\n", 0),
        ("target_link_libraries(node yaml-cpp)\n", 0),
        ("target_link_libraries(node yaml-cpp::yaml-cpp)\n", 0),
        ("# target_link_libraries(node yaml-cpp::yaml-cpp)\n", 1),
        ("include(${MORE})\n", 0),
    ],
)
def test_libraries_that_are_given_in_vain(more: str, count: int) -> None:
    lines = f"find_package(yaml-cpp REQUIRED)\n{NODE}ament_target_dependencies(node rclcpp yaml-cpp)\n{more}"
    assert told(lines, "#include <yaml-cpp/yaml.h>\n") == [("info", "ament_target_dependencies")] * count
    assert told(lines, "#include <rclcpp/rclcpp.hpp>\n") == []


INTERFACES = 'rosidl_generate_interfaces(my_pkg "msg/A.msg" DEPENDENCIES {})\n'
TELLS_NODE = 'rosidl_target_interfaces(node my_pkg "rosidl_typesupport_cpp")\n'


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (f"{INTERFACES.format('sensor_msgs')}{NODE}{TELLS_NODE}", []),
        (f"{INTERFACES.format('sensor_msgs')}{NODE}target_link_libraries(node my_pkg__rosidl_typesupport_cpp)\n", []),
        (f"{INTERFACES.format('${NAMES}')}{NODE}{TELLS_NODE}", []),
        (f"{INTERFACES.format('std_msgs')}{NODE}{TELLS_NODE}", [("warning", "sensor_msgs/msg/image.hpp")]),
        (f"{INTERFACES.format('sensor_msgs')}{NODE}", [("warning", "sensor_msgs/msg/image.hpp")]),
    ],
)
def test_own_interfaces_bring_what_they_depend_on(lines: str, expected: list[tuple[str, str]]) -> None:
    assert told(lines, **{"msg/A.msg": "sensor_msgs/Image image\n"}) == expected


def test_a_header_among_the_sources_is_not_compiled() -> None:
    node = "add_executable(node src/node.cpp src/idle.hpp)\n"
    assert not told(node, "int main() {return 0;}\n", **{"src/idle.hpp": IMAGE})
