"""Sentences and silences of the rules on names in CMake: the project, targets, folders, and what is exported."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest
from rospkg_cli.rules.cmake.cmk110_unknown_target import PLAIN
from rospkg_cli.rules.cmake.cmk119_unexported_targets import LIBRARY

CORE = {"src/core.cpp": "int core() {return 1;}\n", "src/talker.cpp": "int main() {return 0;}\n"}
NAMELESS = CMAKE.replace("project(my_pkg)\n", "")
LINKS = PLAIN.replace("«", "").replace("»", "")
SET = LIBRARY.replace("«", "").replace("»", "")


def package(lines: str, files: dict[str, str] | None = None) -> Example:
    """A CMake package with lines before ament_package()."""
    text = CMAKE.replace("ament_package", lines + "ament_package")
    return Example(bad={"CMakeLists.txt": text, **CORE, **(files or {})}, good={}, on="ament_cmake")


def whole(text: str) -> Example:
    return Example(bad={"CMakeLists.txt": text}, good={}, on="ament_cmake")


def linked(before: str, after: str, files: dict[str, str] | None = None) -> Example:
    assert before in LINKS
    return package(LINKS.replace(before, after), files)


CASES = {
    "CMK001": (
        whole(NAMELESS.replace("ament_package()\n", "")),
        whole(NAMELESS + "include(${somewhere_DIR}/project.cmake)\n"),
        whole(NAMELESS.replace("find_package", "projct(my_pkg)\nfind_package")),
        whole(f"if(FALSE)\n  project(my_pkg)\nendif()\n{NAMELESS}"),
        whole(f'message(FATAL_ERROR "no")\n{NAMELESS}'),
        Example(
            bad={"CMakeLists.txt": NAMELESS, "package.xml": manifest(build_type="cmake")}, good={}, on="ament_cmake"
        ),
    ),
    "CMK102": (
        package(
            "add_subdirectory(srcs)\nadd_subdirectory(docs)\n", {"docs/index.rst": "a\n", "src/CMakeLists.txt": ""}
        ),
        package("add_subdirectory(src)\n", {"src/CMakeLists.txt": ""}),
        package("add_subdirectory(outside ${CMAKE_BINARY_DIR}/outside)\nadd_subdirectory(${CMAKE_BINARY_DIR}/made)\n"),
        package("if(WITH_MORE)\n  add_subdirectory(more)\nendif()\nadd_subdirectory(${MORE})\n"),
        package("include(cmake/tols.cmake)\ninclude(GNUInstallDirs)\n", {"cmake/tools.cmake": ""}),
        package("include(cmake/mine.cmake OPTIONAL)\ninclude(${CMAKE_BINARY_DIR}/made.cmake)\n"),
        package("add_subdirectory(third_party)\n", {".gitmodules": "[submodule 'a']\n  path = third_party\n"}),
    ),
    "CMK110": (
        linked("my_croe", "my_croe my_croe"),
        linked("my_croe", "mu_croe"),
        linked("my_croe", "my_core1"),
        linked("my_croe", "m"),
        linked("my_croe", "my_croe", {"lib/libmy_croe.so": ""}),
        linked("target_link", "find_library(FOUND my_croe)\ntarget_link"),
        linked("target_link", "set_target_properties(my_core PROPERTIES OUTPUT_NAME my_croe)\ntarget_link"),
        linked("target_link", "include(${somewhere_DIR}/more.cmake)\ntarget_link"),
        linked(
            "target_link_libraries(talker PRIVATE my_croe)\n",
            "if(WITH_MORE)\n  target_link_libraries(talker PRIVATE my_croe)\nendif()\n",
        ),
        package("target_link_libraries(talker m)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"),
    ),
    "CMK119": (
        package(SET + "install(EXPORT core_targets DESTINATION share/${PROJECT_NAME}/cmake)\n"),
        package(SET + "if(FALSE)\n  ament_export_targets(core_targets)\nendif()\n"),
        package(SET + "ament_export_targets(${SETS})\n"),
        package(SET + "ament_export_targets(other_targets)\n"),
        package(SET + "team_install_things(core)\n"),
        package(SET + SET.partition("\n")[2]),
        package(SET + "set_target_properties(core PROPERTIES EXPORT_NAME base)\n"),
        package(SET.replace("EXPORT core_targets", "EXPORT ${SET}")),
        package(f"if(WITH_MORE)\n{SET}endif()\n"),
        package(SET.replace("add_library(core SHARED src/core.cpp)", "add_executable(core src/talker.cpp)")),
    ),
}
