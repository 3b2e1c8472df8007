"""Packages that CMake finds in other letters, or may find by what is not here (CMK113, CMK117, DEP107)."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

NEEDS = "<depend>octomap</depend><depend>rclcpp</depend><depend>PCL</depend>"
USER = manifest("  <depend>my_pkg</depend>\n", "ament_cmake").replace("<name>my_pkg", "<name>user")
USES = CMAKE.replace("my_pkg", "user").replace("ament_package", "add_executable(user a.cpp)\nament_package")
USERS = {"user/package.xml": USER, "user/CMakeLists.txt": USES, "user/a.cpp": "#include <my_pkg/core.hpp>\n"}
SOURCES = {"src/core.cpp": '#include "my_pkg/core.hpp"\n#include <octomap/octomap.h>\n'}
HEADERS = {"include/my_pkg/core.hpp": "#include <octomap/octomap.h>\n#include <rclcpp/rclcpp.hpp>\n"}
FOUND = "find_package(octomap REQUIRED)\nfind_package(rclcpp REQUIRED)\n"
LIBRARY = """\
add_library(core SHARED src/core.cpp)
target_link_libraries(core PUBLIC octomap rclcpp::rclcpp)
install(DIRECTORY include/ DESTINATION include)
install(TARGETS core EXPORT core DESTINATION lib)
ament_export_targets(core)
"""
ELSEWHERE = (
    "list(APPEND CMAKE_MODULE_PATH ${CMAKE_SOURCE_DIR}/../cmake)\n",
    "list(APPEND CMAKE_MODULE_PATH $ENV{TOOLS}/cmake)\n",
    "list(APPEND CMAKE_PREFIX_PATH /opt/robots)\n",
    "set(rclpcp_DIR /opt/robots)\n",
    "include(FetchContent)\nFetchContent_Declare(rclpcp URL https://example.org/a.zip)\n",
    "list(APPEND CMAKE_MODULE_PATH ${CMAKE_SOURCE_DIR}/cmake)\n",
    "set(CMAKE_MODULE_PATH ${CMAKE_MODULE_PATH} cmake)\n",
)


def exporting(names: str, found: str = FOUND) -> Example:
    text = CMAKE.replace("ament_package", f"{found}{LIBRARY}ament_export_dependencies({names})\nament_package")
    own = {"package.xml": manifest(NEEDS, "ament_cmake"), "CMakeLists.txt": text, **SOURCES, **HEADERS}
    return Example(bad={**{f"my_pkg/{path}": each for path, each in own.items()}, **USERS}, good={}, on="")


CASED = tuple(exporting(names) for names in ("OCTOMAP rclcpp", "OctoMap rclcpp", "octomap RCLCPP", "octomap Rclcpp"))
CASES = {
    "CMK117": (*CASED, *(exporting("octomap rclpcp", FOUND + lines) for lines in ELSEWHERE)),
    "CMK113": CASED,
    "DEP107": (
        exporting("octomap rclcpp", "find_package(OCTOMAP REQUIRED)\nfind_package(rclcpp REQUIRED)\n"),
        exporting("octomap rclcpp", "find_package(octomap REQUIRED)\nfind_package(RCLCPP REQUIRED)\n"),
    ),
}
