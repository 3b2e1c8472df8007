"""CMK121 unlinked-include."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.unlinked_includes import UnlinkedIncludes
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Severity
from ...rule import rule

NODE = CMAKE.replace(
    "ament_package()",
    "find_package(rclcpp REQUIRED)\nfind_package({found} REQUIRED)\nadd_executable(node src/node.cpp)\n"
    "target_link_libraries(node rclcpp::rclcpp{linked})\n"
    "install(TARGETS node DESTINATION lib/${{PROJECT_NAME}})\nament_package()",
).replace("${PROJECT_NAME})\nament", "${{PROJECT_NAME}})\nament")


def example(package: str, header: str, linked: str) -> Example:
    text = NODE.replace("{found}", package).replace("{{", "{").replace("}}", "}")
    body = f"  <depend>rclcpp</depend>\n  <depend>{package}</depend>\n"
    return Example(
        on="ament_cmake",
        bad={
            "CMakeLists.txt": text.replace("{linked}", ""),
            "package.xml": manifest(body, "ament_cmake"),
            "src/node.cpp": f"#include <rclcpp/rclcpp.hpp>\n#include <«{header}»>\n",
        },
        good={"CMakeLists.txt": text.replace("{linked}", f" {linked}")},
    )


@rule(
    "CMK121",
    "unlinked-include",
    over=UnlinkedIncludes,
    severity=Severity.WARNING,
    levels={Severity.INFO: "where another package's folder of headers may hold them as well"},
    examples=(
        example("sensor_msgs", "sensor_msgs/msg/image.hpp", "${sensor_msgs_TARGETS}"),
        example("tf2_ros", "tf2_ros/buffer.h", "tf2_ros::tf2_ros"),
    ),
)
def unlinked_include(includes: UnlinkedIncludes) -> Iterator[Hit]:
    """
    ## What it does
    Finds targets that include headers of a package that CMake finds, and are not linked with it.
    `find_package()` alone tells no target where the headers are: `target_link_libraries()` does, or
    `ament_target_dependencies()` up to Kilted.

    ## Why is this bad?
    From Humble on each package has a folder of headers of its own, so the build ends with "No such file or directory";
    at the latest the linker misses the symbols.

    ## When it is quiet
    What a target is linked with brings what it passes on itself, as far as package.xml tells; where one link or one
    package is not known, nothing is said of the target. Commands for all targets (`include_directories()`), targets of
    `ament_auto_add_…()` and of tests, includes under `#if`, and calls under a condition are left alone.

    ## References
    - [ament_cmake user documentation](https://docs.ros.org/en/rolling/How-To-Guides/Ament-CMake-Documentation.html)
    """
    for each in includes.all():
        ends = 'the build ends with "No such file or directory"'
        if not each.is_own_folder:
            ends = "it builds only where the headers lie in a folder that others share"
        message = (
            f"`{each.header}` is included here, and `{each.target.name}` is not linked with `{each.package}`: {ends}; "
            f"add it to `target_link_libraries({each.target.name} …)`"
        )
        yield Hit(each.path, each.span, message, None if each.is_own_folder else Severity.INFO)
