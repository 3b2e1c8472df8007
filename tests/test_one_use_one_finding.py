"""Uses that two rules could speak of, and declarations of which one rule relies on what another doubts."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files


def codes(files: dict[str, str], *only: str) -> list[tuple[str, str]]:
    return [(f.code, f.location.path) for f in lint_files(files, list(only)).findings]


def test_a_launch_test_among_the_modules_is_a_test(clean) -> None:
    code = (
        "from launch import LaunchDescription\n\n\ndef generate_test_description():\n    return LaunchDescription([])\n"
    )
    files = {**clean, "my_pkg/talks_launch_test.py": f"from rcl_interfaces.srv import SetParameters\n{code}"}
    assert codes(files, "DEP101", "DEP102", "DEP103") == [("DEP102", "my_pkg/talks_launch_test.py")] * 2
    files = {**clean, "my_pkg/talks.py": "import launch_pytest\n"}
    assert codes(files, "DEP101", "DEP102") == [("DEP102", "my_pkg/talks.py")]
    assert codes({**clean, "my_pkg/talks.py": "import launch\n"}, "DEP101", "DEP102") == [("DEP101", "my_pkg/talks.py")]


def test_what_modules_import_is_not_asked_for_again_by_launch_files(clean) -> None:
    node = '<launch>\n  <node pkg="tf2_ros" exec="static_transform_publisher"/>\n</launch>\n'
    files = {**clean, "launch/a.launch.xml": node}
    assert codes(files, "DEP101", "DEP103") == [("DEP103", "launch/a.launch.xml")]
    files["my_pkg/a.py"] = "import rclpy\nimport tf2_ros\n"
    assert ("DEP103", "launch/a.launch.xml") in codes(files, "DEP101", "DEP103")
    files |= {"launch/a.launch.xml": node.replace("tf2_ros", "nav2_msgs"), "my_pkg/a.py": "import nav2_msgs.msg\n"}
    assert codes(files, "DEP101", "DEP103") == [("DEP101", "my_pkg/a.py")]


def test_a_package_is_no_other_way_to_get_what_it_looks_for() -> None:
    text = manifest("  <test_depend>python3-opencv</test_depend>\n", "ament_cmake", "cv_bridge")
    cmake = CMAKE.replace("my_pkg", "cv_bridge").replace(
        "ament_package", "find_package(OpenCV REQUIRED)\nament_package"
    )
    found = lint_files({"package.xml": text, "CMakeLists.txt": cmake}, ["DEP104"]).findings
    assert ["libopencv-dev" in each.message for each in found] == [True]


def test_what_brings_the_tool_that_tests_import_is_used() -> None:
    depends = "  <test_depend>launch_testing_ros</test_depend>\n"
    files = {
        "package.xml": manifest(depends, "ament_cmake"),
        "CMakeLists.txt": CMAKE,
        "test/test_talks.py": "import launch_testing.actions\n",
    }
    assert codes(files, "DEP202") == []
    assert codes({**files, "test/test_talks.py": "import pytest\n"}, "DEP202") == [("DEP202", "package.xml")]


NEEDS = "  <build_export_depend>std_msgs</build_export_depend>\n"
LIBRARY = "add_library(a src/a.cpp)\ninstall(DIRECTORY include/ DESTINATION include)\n"


@pytest.mark.parametrize(
    ("depends", "lines", "source", "count"),
    [
        (NEEDS, LIBRARY, "int a() {return 0;}\n", 0),
        (NEEDS, LIBRARY, "#include <my_pkg/a.hpp>\n", 1),
        (NEEDS.replace("build_export", "test"), LIBRARY, "int a() {return 0;}\n", 1),
        (
            NEEDS,
            f"execute_process(COMMAND ls OUTPUT_VARIABLE FOUND)\nadd_library(b ${{FOUND}})\n{LIBRARY}",
            "int a() {return 0;}\n",
            1,
        ),
    ],
)
def test_headers_for_others_are_exported(depends: str, lines: str, source: str, count: int) -> None:
    files = {
        "package.xml": manifest(depends, "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}ament_package"),
        "include/my_pkg/a.hpp": "#include <std_msgs/msg/string.hpp>\n",
        "src/a.cpp": source,
    }
    assert len(codes(files, "DEP201")) == count


def test_a_demo_that_needs_more_is_an_info(clean) -> None:
    node = '<launch>\n  <node pkg="joy" exec="joy_node"/>\n</launch>\n'
    files = {**clean, "tracks.yaml": "tracks: {}\n", "launch/demo_arm.launch.xml": node}
    files["package.xml"] = clean["package.xml"].replace("  <export>", "  <test_depend>joy</test_depend>\n  <export>")
    (finding,) = lint_files(files, ["DEP201"]).findings
    assert finding.severity.value == "info"
    (finding,) = lint_files({**files, "launch/robot.launch.xml": node}, ["DEP201"]).findings
    assert (finding.severity.value, finding.location.path) == ("warning", "launch/robot.launch.xml")
