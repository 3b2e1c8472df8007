"""Libraries in a folder where no loader looks: linked with what includes their headers, or not (CMK103)."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

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


NUMBERS = {
    "src/core.cpp": '#include "my_pkg/sizes.hpp"\n' + USE,
    "src/talker.cpp": '#include "my_pkg/sizes.hpp"\n' + MAIN,
}
SIZES = "static constexpr int SIZE = 1;\nstruct Size {int width;};\n"
INSTALLED = LINES.replace("core talker DEST", "talker DEST")
EXPORTS = "add_library(core SHARED src/core.cpp)\nament_export_libraries(core)\n"
USER = {
    "user/package.xml": manifest("  <depend>my_pkg</depend>\n", "ament_cmake").replace("<name>my_pkg", "<name>user"),
    "user/CMakeLists.txt": CMAKE.replace("(my_pkg)", "(user)").replace(
        "ament_package", "find_package(my_pkg REQUIRED)\nadd_executable(user src/user.cpp)\nament_package"
    ),
    "user/src/user.cpp": MAIN,
}


def beside_user(lines: str) -> Example:
    """Return a package and another one whose CMake looks for it."""
    own = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", lines + "ament_package"),
    }
    return Example(bad={**{f"my_pkg/{path}": text for path, text in (own | FILES).items()}, **USER}, good={}, on="")


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
        package(LINES, {"src/talker.cpp": USE + '#include "core.cpp"\n' + MAIN}),
        package(LINES, {"src/talker.cpp": '#include "all.hpp"\n' + MAIN, "src/all.hpp": USE + '#include "core.cpp"\n'}),
        package(LINES.replace("src/core", "src/more.cpp src/core"), {"src/talker.cpp": USE + '#include "core.cpp"\n'}),
        package(LINES, NUMBERS | {"include/my_pkg/sizes.hpp": SIZES}),
        package(LINES, NUMBERS | {"include/my_pkg/sizes.hpp": SIZES + "int size();\n"}),
        package(INSTALLED, {"src/talker.cpp": USE + MAIN}),
        package(INSTALLED, {"src/talker.cpp": USE + '#include "core.cpp"\n' + MAIN}),
        package(
            INSTALLED, {"src/talker.cpp": "#include <ros/ros.h>\n" + USE + MAIN, "src/core.cpp": "#include <tf/tf.h>\n"}
        ),
        package(EXPORTS, {}),
        beside_user(EXPORTS),
    ),
}
