"""Sentences and silences of the rules on names in CMake: the project, targets, folders, and what is exported."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest
from rospkg_cli.rules.cmake.cmk110_unknown_target import PLAIN
from rospkg_cli.rules.cmake.cmk119_unexported_targets import LIBRARY

CORE = {"src/core.cpp": "int core() {return 1;}\n", "src/talker.cpp": "int main() {return 0;}\n"}
NAMELESS = CMAKE.replace("project(my_pkg)\n", "")
LINKS = PLAIN.replace("«", "").replace("»", "")
SET = LIBRARY.replace("«", "").replace("»", "")
HEADER = {"include/my_pkg/core.hpp": "int core();\n"}


def package(lines: str, files: dict[str, str] | None = None) -> Example:
    """A CMake package with lines before ament_package()."""
    text = CMAKE.replace("ament_package", lines + "ament_package")
    return Example(bad={"CMakeLists.txt": text, **CORE, **(files or {})}, good={}, on="ament_cmake")


def whole(text: str) -> Example:
    return Example(bad={"CMakeLists.txt": text}, good={}, on="ament_cmake")


def linked(before: str, after: str, files: dict[str, str] | None = None) -> Example:
    assert before in LINKS
    return package(LINKS.replace(before, after), files)


def launch(install: str) -> Example:
    files = {"launch/talker.launch.xml": "<launch/>\n", "launch/listener.launch.xml": "<launch/>\n"}
    return package(f"install(DIRECTORY {install})\n", files)


def finds(name: str, target: str) -> Example:
    """A library that links a target of a package that nobody knows."""
    link = f"target_link_libraries(core PUBLIC {name}::{target})\n"
    return package(f"find_package({name} REQUIRED)\nadd_library(core SHARED src/core.cpp)\n{link}")


def headers(destination: str, more: str = "", where: str = "include") -> Example:
    """A library whose headers are installed in one call, and exported."""
    lines = f"{LIBRARY_ALONE}install(DIRECTORY {where} DESTINATION {destination})\n{more}"
    files = {"include/my_pkg/core.hpp": "#pragma once\nint core();\n"}
    return package(f"{lines}ament_export_include_directories(include)\n", files)


LIBRARY_ALONE = (
    "add_library(core SHARED src/core.cpp)\ninstall(TARGETS core DESTINATION lib)\nament_export_libraries(core)\n"
)

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
    "CMK101": (
        launch("launch DESTINATION launch"),
        launch("launch DESTINATION share"),
        launch("launch DESTINATION share/${PROJECT_NAME}"),
        launch("launch/ DESTINATION share/${PROJECT_NAME}/launch"),
        launch("launch DESTINATION share)\ninstall(DIRECTORY launch DESTINATION share/${PROJECT_NAME}"),
        launch("launch DESTINATION ${SOMEWHERE}"),
        launch("launch DESTINATION launch)\nif(WITH_MORE)\n  install(DIRECTORY launch DESTINATION share)\nendif("),
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
        finds("camera_driver", "camera_drver"),
        finds("camera_driver", "camera_drrver_x"),
        finds("camera2_driver", "camera_driver"),
        finds("camera", "camerra"),
        finds("Camera_driver", "Camera_drver"),
        package("target_link_libraries(talker m)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"),
    ),
    "CMK119": (
        *(
            package(SET.replace("core_targets", "core") + lines)
            for lines in (
                "ament_export_libraries(core)\n",
                "ament_export_libraries(core)\nament_export_targets(core)\n",
            )
        ),
        package(SET + "install(EXPORT core_targets DESTINATION share/${PROJECT_NAME}/cmake)\n"),
        package(SET + "if(FALSE)\n  ament_export_targets(core_targets)\nendif()\n"),
        package(SET + "ament_export_targets(${SETS})\n"),
        package(SET + "target_link_libraries(core ${THEIR_TARGETS})\n", HEADER),
        package(SET + "ament_export_targets(other_targets)\n", HEADER),
        package(SET + "team_install_things(core)\n"),
        package(SET + 'rclcpp_components_register_nodes(core "my_pkg::Core")\n'),
        package(SET, {"src/core.cpp": "PLUGINLIB_EXPORT_CLASS(my_pkg::Core, my_pkg::Base)\n"}),
        package("generate_parameter_library(core core.yaml)\n" + SET.partition("\n")[2], {"core.yaml": "core: {}\n"}),
        package(SET, HEADER | {"src/other.cpp": "PLUGINLIB_EXPORT_CLASS(my_pkg::Core, my_pkg::Base)\n"}),
        package(SET + SET.partition("\n")[2], HEADER),
        package(SET + "set_target_properties(core PROPERTIES EXPORT_NAME base)\n", HEADER),
        package(SET.replace("EXPORT core_targets", "EXPORT ${SET}")),
        package(f"if(WITH_MORE)\n{SET}endif()\n"),
        package(SET.replace("add_library(core SHARED src/core.cpp)", "add_executable(core src/talker.cpp)")),
    ),
    "CMK106": (
        headers("include"),
        headers("include", "ament_export_include_directories(include/include)\n"),
        headers("include/${PROJECT_NAME}"),
        headers("include", "install(DIRECTORY include/ DESTINATION include)\n"),
        headers("include", "pluginlib_export_plugin_description_file(rviz_common a.xml)\n"),
        headers("share"),
        headers("include", where="include/"),
        headers("include", where="src"),
        package("install(DIRECTORY include DESTINATION include)\n", {"include/my_pkg/core.hpp": "#pragma once\n"}),
        headers("include", "install(DIRECTORY ${MORE} DESTINATION include)\n"),
    ),
    "CMK115": (
        package(
            "find_package(ament_index_cpp REQUIRED)\nmessage(${A})\ninclude_directories(${AMENT_INDEX_CPP_LIBRARIES})\n"
        ),
        package("find_package(tinyxml2_vendor REQUIRED)\ninclude_directories(${TINYXML2_VENDOR_LIBRARIES})\n"),
        package("find_package(camera_driver REQUIRED)\ninclude_directories(${CAMERA_DRIVER_LIBRARIES})\n"),
        package("list(APPEND CORE_SUORCES a.cpp)\nlist(PREPEND CORE_SUORCES b.cpp)\nmessage(${CORE_SOURCES})\n"),
        package("list(APPEND CORE_SUORCES a.cpp)\nmessage(${CORE_SOURCES} ${CORE_SUORCES})\n"),
        package("list(APPEND CORE_SUORCES a.cpp)\nmessage(${CORE_SOURCES})\n# CORE_SUORCES\n"),
        package("list(APPEND CORE_SOURCES2 a.cpp)\nmessage(${CORE_SOURCES})\n"),
        package("list(APPEND CORE_SUORCES a.cpp)\nmessage(${CORE_SOURCE} ${CORE_SUORCE})\n"),
        package("list(APPEND SUORCES a.cpp)\nmessage(${SOURCES})\n"),
        package("list(APPEND CORE_SUORCES a.cpp)\ninclude(${somewhere_DIR}/a.cmake)\nmessage(${CORE_SOURCES})\n"),
        package("list(SORT CORE_SUORCES)\nlist(APPEND CORE_SUORCES)\nmessage(${CORE_SOURCES})\n"),
    ),
    "CMK117": (
        package("find_package(OpenCV REQUIRED)\nament_export_dependencies(${OpenCV_LIBRARIES})\n"),
        package("find_package(tf2 REQUIRED)\nament_export_dependencies(${TF2_LIBS} ${nobody_TARGETS} ${MORE})\n"),
        package("set(MORE_LIBRARIES tf2)\nament_export_dependencies(${MORE_LIBRARIES})\n"),
        package("if(WITH_MORE)\n  ament_export_dependencies(${OpenCV_LIBRARIES})\nendif()\n"),
        package("find_package(my_pkg REQUIRED)\n"),
        package("find_package(Eigen3::Eigen REQUIRED)\nfind_package(MANIF::manif QUIET)\n"),
        package("if(WITH_MORE)\n  find_package(Eigen3::Eigen REQUIRED)\nendif()\n"),
        *(
            package(lines + "ament_export_dependencies(acme_arm)\n", files)
            for lines, files in (
                ("", {}),
                ("find_package(acme_arm)\n", {}),
                ("include(${MORE}/a.cmake)\n", {}),
                ("find_library(ARM NAMES acme_arm_core)\n", {}),
                ("", {"cmake/Findacme_arm.cmake": ""}),
            )
        ),
        package("ament_export_dependencies(yaml-cpp tinyxml2 Acme)\n"),
        package("find_package(${PROJECT_NAME} QUIET)\n"),
        package("find_package(my_pkg REQUIRED)\n", {"cmake/Findmy_pkg.cmake": ""}),
        package("if(BUILD_TESTING)\n  find_package(my_pkg REQUIRED)\nendif()\n"),
        package("add_subdirectory(src)\n", {"src/CMakeLists.txt": "find_package(my_pkg REQUIRED)\n"}),
    ),
}
