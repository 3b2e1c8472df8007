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
        "add_library(part SHARED src/part.cpp)\ntarget_link_libraries(part PRIVATE ${sensor_msgs_TARGETS})\n"
        f"{NODE}target_link_libraries(node part)\n",
        f"include_directories(BEFORE include ${{Boost_INCLUDE_DIRS}})\n{NODE}",
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
        f"{NODE}ament_target_dependencies(node nobodys)\n",
        f"{NODE}target_link_libraries(node ${{MORE}} $<TARGET_OBJECTS:x>)\n",
        f"{NODE}target_include_directories(node PRIVATE ${{sensor_msgs_INCLUDE_DIRS}})\n",
        f"{NODE}include_directories(/opt/x)\n",
        f"{NODE}include_directories(${{sensor_msgs_INCLUDE_DIRS}})\n",
        f"{NODE}include_directories(${{nobodys_INCLUDE_DIRS}})\n",
        f"{NODE}include_directories(${{MORE}})\n",
        f"{NODE}link_libraries(sensor_msgs::sensor_msgs)\n",
        "ament_auto_add_executable(node src/node.cpp)\n",
        f"if(BUILD_TESTING)\n  {NODE}endif()\n",
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
