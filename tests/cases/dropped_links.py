"""Libraries in a folder where no loader looks: linked with what includes their headers, or not (CMK103)."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example

LINES = """\
add_library(core SHARED src/core.cpp)
add_executable(talker src/talker.cpp)
target_link_libraries(talker core)
install(TARGETS core talker DESTINATION lib/${PROJECT_NAME})
"""
SECOND = "add_executable(other src/other.cpp)\ntarget_link_libraries(other core)\n"
MAIN = "int main() {return 0;}\n"
USE = '#include "my_pkg/core.hpp"\n'
FILES = {"src/core.cpp": USE, "include/my_pkg/core.hpp": "int core();\n", "src/talker.cpp": MAIN}
THROUGH = {"src/talker.cpp": '#include "tools.hpp"\n' + MAIN, "src/tools.hpp": USE}


def package(lines: str, files: dict[str, str]) -> Example:
    text = CMAKE.replace("ament_package", lines + "ament_package")
    return Example(bad={"CMakeLists.txt": text, **FILES, **files}, good={}, on="ament_cmake")


CASES = {
    "CMK103": (
        package(LINES, {}),
        package(LINES, {"src/talker.cpp": USE + MAIN}),
        package(LINES, THROUGH),
        package(LINES, {"src/core.cpp": "int core() {return 1;}\n"}),
        package(LINES + SECOND, {"src/other.cpp": MAIN}),
        package(LINES + SECOND, {"src/other.cpp": USE + MAIN}),
        package(LINES + "target_sources(talker PRIVATE ${MORE})\n", {}),
        package(LINES + "target_link_options(talker PRIVATE -Wl,--no-as-needed)\n", {}),
        package(LINES + 'rclcpp_components_register_nodes(core "my_pkg::Core")\n', {}),
    ),
}
