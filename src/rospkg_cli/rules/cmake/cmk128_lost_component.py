"""CMK128 lost-component."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cpp.lost_components import LostComponents
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Severity
from ...rule import rule

LINES = """\
find_package(rclcpp REQUIRED)
find_package(Boost REQUIRED COMPONENTS {})
add_executable(talker src/talker.cpp)
target_link_libraries(talker PRIVATE rclcpp::rclcpp {})
install(TARGETS talker DESTINATION lib/${{PROJECT_NAME}})
"""
VISION = """\
find_package(OpenCV REQUIRED COMPONENTS {})
add_executable(viewer src/viewer.cpp)
target_link_libraries(viewer PRIVATE ${{OpenCV_LIBS}})
install(TARGETS viewer DESTINATION lib/${{PROJECT_NAME}})
"""
VIEWER = """\
#include <opencv2/opencv.hpp>

int main() {
  «cv::imread»("a.png");
}
"""


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package", lines + "ament_package")


@rule(
    "CMK128",
    "lost-component",
    over=LostComponents,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "a source calls what OpenCV has in a component that is not asked for",
        Severity.INFO: "another package that is found may ask for the component itself",
    },
    examples=(
        Example(
            bad={
                "CMakeLists.txt": cmake(LINES.format("program_options", "«Boost::filesystem»")),
                "package.xml": manifest("  <depend>libboost-dev</depend>\n  <depend>rclcpp</depend>\n", "ament_cmake"),
                "src/talker.cpp": "int main() {return 0;}\n",
            },
            good={"CMakeLists.txt": cmake(LINES.format("filesystem", "Boost::filesystem"))},
            on="ament_cmake",
        ),
        Example(
            bad={
                "CMakeLists.txt": cmake(VISION.format("core imgproc")),
                "package.xml": manifest("  <depend>libopencv-dev</depend>\n", "ament_cmake"),
                "src/viewer.cpp": VIEWER,
            },
            good={"CMakeLists.txt": cmake(VISION.format("core imgcodecs imgproc"))},
            on="ament_cmake",
        ),
    ),
)
def lost_component(components: LostComponents) -> Iterator[Hit]:
    """
    ## What it does
    Finds components of Boost, Qt and OpenCV that targets need and CMake does not ask for.
    Of Boost and Qt it compares the targets that are linked (`Boost::filesystem`), of OpenCV the functions and classes
    that sources use, such as `cv::imread` of imgcodecs, where `${OpenCV_LIBS}` has only what was asked for.

    ## Why is this bad?
    CMake stops because nothing makes the target. Of OpenCV the library is not linked: the linker stops with an
    undefined reference, or the loader with an undefined symbol.

    ## When it is quiet
    What comes with a component that is asked for is there, too, as `Qt5::Core` with Widgets. Where a component or a
    package can't be evaluated, where it is not known what comes along, where a command of another package may find
    anything, and under a condition. For OpenCV where no component is asked for (all are found), where the name of the
    component stands anywhere in CMake, and where a package may find it for its users; cv_bridge finds four.
    """
    for each in components.all():
        if each.library == "OpenCV":
            message = (
                f"`{each.used}` is in `{each.component}`, a component that `find_package(OpenCV …)` does not ask for: "
                "the linker or the loader stops with an undefined symbol; add it to COMPONENTS"
            )
            yield Hit(each.path, each.span, message, Severity.WARNING)
            continue
        start = f"`{each.used}` is linked, and `find_package({each.library} …)` does not ask for `{each.component}`"
        ends = "CMake stops because nothing makes the target"
        if each.stranger:
            ends = f"the target is there only if `{each.stranger}` or the like asks for it"
        message = f"{start}: {ends}; add `{each.component}` to COMPONENTS"
        yield Hit(each.path, each.span, message, Severity.INFO if each.stranger else None)
