"""Components of Boost, Qt and OpenCV that are needed and that CMake does not ask for (CMK128, CMK113)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

LINKED = "add_executable(node src/node.cpp)\ntarget_link_libraries(node {})\n"
SHOWS = 'int main() {cv::Mat m = cv::imread("a.png"); cv::imshow("a", m);}\n'
NEEDS = "  <depend>libboost-dev</depend>\n  <depend>libopencv-dev</depend>\n"


def told(lines: str, source: str = "int main() {}\n", needs: str = NEEDS, code: str = "CMK128") -> list[str]:
    """Return level and first name of each finding."""
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{lines}ament_package()"),
        "package.xml": manifest(needs, "ament_cmake"),
        "src/node.cpp": source,
    }
    return [f"{f.severity.value} {f.message.split('`')[1]}" for f in lint_files(files, [code]).findings]


@pytest.mark.parametrize(
    ("finds", "linked", "expected"),
    [
        ("Boost REQUIRED", "Boost::filesystem", ["error Boost::filesystem"]),
        ("Boost REQUIRED COMPONENTS system", "Boost::thread", ["error Boost::thread"]),
        ("Boost 1.71 REQUIRED system", "Boost::thread", ["error Boost::thread"]),
        ("Boost REQUIRED COMPONENTS thread", "Boost::chrono Boost::thread", []),
        ("Boost REQUIRED COMPONENTS coroutine", "Boost::thread", []),
        ("Boost REQUIRED COMPONENTS ${PARTS}", "Boost::thread", []),
        ("Boost REQUIRED", "Boost::boost Boost::headers Boost::unheard", []),
        ("Qt5 REQUIRED COMPONENTS Widgets", "Qt5::Core Qt5::Gui Qt5::Widgets", []),
        ("Qt5 REQUIRED COMPONENTS Core", "Qt5::Core Qt5::Widgets", ["error Qt5::Widgets"]),
        ("Qt5 REQUIRED COMPONENTS Core)\nfind_package(Qt5Widgets REQUIRED", "Qt5::Widgets", []),
        ("Qt6 REQUIRED COMPONENTS Widgets", "Qt6::Widgets Qt6::Network", ["error Qt6::Network"]),
        ("Qt${V} REQUIRED COMPONENTS Widgets)\nfind_package(Qt5 COMPONENTS Core", "Qt5::Widgets", []),
        ("Boost REQUIRED)\nfind_package(pcl_ros REQUIRED", "Boost::thread", ["info Boost::thread"]),
        ("Boost REQUIRED)\nadd_library(Boost::thread SHARED IMPORTED", "Boost::thread", []),
        ("Boost REQUIRED)\nteam_finds(all", "Boost::thread", []),
        ("Boost REQUIRED)\ninclude(${MORE}", "Boost::thread", []),
        ("OpenCV REQUIRED", "opencv_core OpenCV::core", []),
    ],
)
def test_targets_of_components(finds: str, linked: str, expected: list[str]) -> None:
    assert told(f"find_package({finds})\n{LINKED.format(linked)}") == expected
    assert told(f"find_package({finds})\nif(X)\n{LINKED.format(linked)}endif()\n") == []


@pytest.mark.parametrize(
    ("finds", "expected"),
    [
        ("OpenCV REQUIRED", []),
        ("OpenCV REQUIRED COMPONENTS core imgproc", ["cv::imread", "cv::imshow"]),
        ("OpenCV REQUIRED COMPONENTS opencv_core opencv_imgcodecs", ["cv::imshow"]),
        ("OpenCV REQUIRED COMPONENTS highgui", []),
        ("OpenCV REQUIRED COMPONENTS core aruco", []),
        ("OpenCV REQUIRED COMPONENTS core)\nfind_package(OpenCV REQUIRED", []),
        ("OpenCV REQUIRED COMPONENTS core)\nfind_package(cv_bridge REQUIRED", ["cv::imshow"]),
        ("OpenCV REQUIRED COMPONENTS core)\nfind_package(image_geometry REQUIRED", []),
        ("OpenCV REQUIRED OPTIONAL_COMPONENTS core", []),
    ],
)
def test_what_sources_call(finds: str, expected: list[str]) -> None:
    linked = f"find_package({finds})\n{LINKED}"
    assert told(linked.format("${OpenCV_LIBS}"), SHOWS) == [f"warning {each}" for each in expected]
    assert told(linked.format("${OpenCV_LIBS} opencv_imgcodecs opencv_highgui"), SHOWS) == []
    assert told(linked.format("${OpenCV_LIBS}"), "int main() {my::cv::imread(); /* cv::imshow */}\n") == []


def test_what_package_xml_finds() -> None:
    lines = "find_package(ament_cmake_auto REQUIRED)\nament_auto_find_build_dependencies()\n"
    linked = f"{lines}find_package(OpenCV REQUIRED COMPONENTS core)\n{LINKED.format('${OpenCV_LIBS}')}"
    assert told(linked, SHOWS) == ["warning cv::imread", "warning cv::imshow"]
    assert told(linked, SHOWS, f"{NEEDS}  <depend>image_geometry</depend>\n") == []


EXPORTED = """\
find_package(Boost REQUIRED COMPONENTS {0})
add_library(node SHARED src/node.cpp)
{1}
install(TARGETS node EXPORT export_node DESTINATION lib)
ament_export_targets(export_node)
ament_export_dependencies(Boost)
"""


@pytest.mark.parametrize(
    ("asked", "link", "expected"),
    [
        ("filesystem", "target_link_libraries(node PUBLIC Boost::filesystem)", ["info node"]),
        ("filesystem", "target_link_libraries(node Boost::filesystem)", ["info node"]),
        ("filesystem", "target_link_libraries(node ${Boost_LIBRARIES})", ["info node"]),
        ("filesystem", "ament_target_dependencies(node Boost)", ["info node"]),
        ("", "ament_target_dependencies(node Boost)", []),
        ("filesystem", "target_link_libraries(node PRIVATE Boost::filesystem)", []),
        ("filesystem", "target_link_libraries(node PUBLIC Boost::boost)", []),
        ("filesystem", "target_link_libraries(node PUBLIC Boost::filesystem)\n# CONFIG_EXTRAS", ["info node"]),
    ],
)
def test_components_that_users_do_not_find(asked: str, link: str, expected: list[str]) -> None:
    lines = EXPORTED.format(asked, link)
    assert told(lines, code="CMK113") == expected
    others = lines.replace("dependencies(Boost", "dependencies(pcl_ros Boost")
    assert all(each.startswith("info") for each in told(others, code="CMK113"))
    assert told(lines.replace("dependencies(Boost", "dependencies(rclcpp"), code="CMK113") == []
    assert told(f'{lines}ament_package(CONFIG_EXTRAS "a.cmake")\n', code="CMK113") == []
