"""Faults of CMake and package.xml that people repaired in their repositories: neighbours of each, and silences."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

CORE = {"src/core.cpp": "int core() {return 1;}\n", "include/my_pkg/core.hpp": "int core();\n"}
TESTED = "if(BUILD_TESTING)\n{}endif()\n"
ADDED = "  ament_add_gtest(test_core test/test_core.cpp)\n"
TESTS = {"test/test_core.cpp": "int main() {return 0;}\n"}
LAUNCH = {"launch/robot.launch.py": "LAUNCH = 1\n", "README.md": "`ros2 launch my_pkg robot.launch.py`\n"}
MADE = "install(DIRECTORY {} DESTINATION share/${{PROJECT_NAME}}{})\n"
UNSET = """\
set(MY_PKG_WORK_FOLDER "lib")
set(_PX_CORE_PROGRAMS_DIR "lib/my_pkg")
add_executable(core src/core.cpp)
install(TARGETS core DESTINATION ${%s})
"""
LIBRARY = """\
find_package(rclcpp REQUIRED)
find_package(std_msgs REQUIRED)
add_library(core SHARED src/core.cpp)
{0}
install(DIRECTORY include/ DESTINATION include)
install(TARGETS core EXPORT core_targets DESTINATION lib)
{1}
ament_export_dependencies({2})
"""
NEEDS = "  <depend>rclcpp</depend>\n  <depend>std_msgs</depend>\n"
EXPORTS = "ament_export_targets(core_targets)"
LINKS = "target_link_libraries(core {}rclcpp::rclcpp ${{std_msgs_TARGETS}})"
HANDS = "ament_target_dependencies(core rclcpp std_msgs)"
TOLD = """\
add_library(core SHARED src/core.cpp)
target_include_directories(core PUBLIC $<INSTALL_INTERFACE:{1}>)
install(DIRECTORY include/ DESTINATION {0})
install(TARGETS core EXPORT core_targets DESTINATION lib)
ament_export_targets(core_targets)
{2}
"""
LINKED = """\
find_package(create_driver REQUIRED)
find_package(tf2_ros REQUIRED)
add_executable(node src/node.cpp)
target_link_libraries(node {})
"""
NODE = {"src/node.cpp": "#include <tf2_ros/buffer.h>\nint main() {return 0;}\n"}
BASE = "  <depend>create_driver</depend>\n  <depend>tf2_ros</depend>\n"
PROGRAMS = {"scripts/calibrate": "#!/bin/sh\n", "scripts/notes.txt": "nothing\n"}
MODULE = "find_path(GDAL_INCLUDE_DIRS gdal.h)\n"


def package(lines: str, files: dict[str, str], body: str = "") -> Example:
    """A CMake package with lines before ament_package()."""
    text = CMAKE.replace("ament_package", lines + "ament_package")
    files = {"package.xml": manifest(body, "ament_cmake"), **files}
    return Example(bad={"CMakeLists.txt": text, **files}, good={}, on="ament_cmake")


def library(use: str, exports: str = EXPORTS, names: str = "") -> Example:
    return package(LIBRARY.format(use, exports, names), CORE, NEEDS)


def exported(name: str, body: str) -> Example:
    return package(f"find_package({name} REQUIRED)\nament_export_dependencies({name})\n", {}, body)


def node(links: str, body: str = BASE) -> Example:
    return package(LINKED.format(links), NODE, body)


TALKER = "class Talker {};\n"
MAIN = "int main() {return 0;}\n"
PLAIN = "add_executable(talker src/talker.cpp)"


def program(lines: str, text: str, *others: str) -> Example:
    return package(f"{lines}\n", {"src/talker.cpp": text, **dict.fromkeys(others, MAIN)})


POINTS = {"src/talker.cpp": "#include <pcl/point_types.h>\n" + MAIN}
RCLCPP = "  <depend>rclcpp</depend>\n"
STRING = "#include <std_msgs/msg/string.hpp>\n"


def switched(defines: str, text: str) -> Example:
    """A program that includes a header under a condition."""
    return program(f"{defines}\n{PLAIN}", text.format(STRING) + MAIN)


OPTION = 'option(WITH_A "With a" OFF)\nset(FILES src/b.cpp ${OTHERS_OF_SYSTEM})\nif(WITH_A)\n  '
ON_DEMAND = {
    "src/a.cpp": "#include <yaml-cpp/yaml.h>\nint a() {return 0;}\n",
    "src/b.cpp": "int main() {return 0;}\n",
}
CASES = {
    "DEP104": (
        package("find_package(ZLIB REQUIRED QUIET)\n", {}),
        package("find_package(ZLIB QUIET)\n", {}),
        package(TESTED.format("  find_package(ament_cmake_gtest)\n" + ADDED), TESTS),
        package(TESTED.format("  find_package(ament_cmake_gtest QUIET)\n" + ADDED), TESTS),
        package(
            TESTED.format(
                "  find_package(ament_cmake_gtest)\n  if(ament_cmake_gtest_FOUND)\n  " + ADDED + "  endif()\n"
            ),
            TESTS,
        ),
        package("find_package(LTTngUST REQUIRED)\n", {}),
        package("find_package(GDAL REQUIRED)\n", {"cmake/FindGDAL.cmake": MODULE}),
        package("find_package(GDAL REQUIRED)\n", {"cmake/FindGDAL.cmake": MODULE + "set(A ${CMAKE_SOURCE_DIR})\n"}),
        package("find_package(GDAL REQUIRED)\n", {"cmake/GDALConfig.cmake": MODULE}),
    ),
    "DEP105": (
        Example(
            on="",
            good={},
            bad={
                "port/package.xml": manifest("", "cmake").replace("<name>my_pkg", "<name>port"),
                "port/CMakeLists.txt": "project(port)\n",
                "port/ports/other/include/sys/time.h": "\n",
                "user/package.xml": manifest("", "ament_cmake"),
                "user/CMakeLists.txt": CMAKE.replace("ament_package", "add_executable(a src/a.cpp)\nament_package"),
                "user/src/a.cpp": "#include <sys/shm.h>\nint main() {return 0;}\n",
            },
        ),
        package(f"{OPTION}list(APPEND FILES src/a.cpp)\nendif()\nadd_executable(b ${{FILES}})\n", ON_DEMAND),
        switched("add_definitions(-DON_ROS)", "#ifdef ON_ROS\n{}#endif\n"),
        switched("add_compile_definitions(ON_ROS=1)", "#if defined(ON_ROS)\n{}#endif\n"),
        switched(
            "add_definitions(-DON_ROS)", "#ifndef MY_PKG_NODE\n#define MY_PKG_NODE\n#if ON_ROS\n{}#endif\n#endif\n"
        ),
        switched("add_definitions(-DON_ROS)", "#ifdef ON_ROS\n#else\n{}#endif\n"),
        switched("add_definitions(-DON_ROS)", "#ifndef ON_ROS\n{}#endif\n"),
        switched("add_definitions(-DON_ROS)", "#ifdef ON_ROS\n#ifdef WITH\n{}#endif\n#endif\n"),
        switched("add_definitions(-DON_ROS)", "#if ON_ROS > 1\n{}#endif\n"),
        switched("if(WITH)\n  add_definitions(-DON_ROS)\nendif()", "#ifdef ON_ROS\n{}#endif\n"),
    ),
    "DEP107": (
        *(
            package(f"find_package(rclcpp REQUIRED)\n{more}{PLAIN}\n", POINTS, f"  <depend>{key}</depend>\n{RCLCPP}")
            for more, key in (
                ("", "libpcl-all-dev"),
                ("find_package(pcl_conversions REQUIRED)\n", "libpcl-all-dev"),
                ("find_package(PCL REQUIRED)\n", "libpcl-all-dev"),
                ("include_directories(${PCL_INCLUDE_DIRS})\n", "libpcl-all-dev"),
                ("ament_auto_find_build_dependencies()\n", "libpcl-all-dev"),
                ("include(${WHERE}/all.cmake)\n", "libpcl-all-dev"),
                ("", "std_msgs"),
            )
        ),
        package(LIBRARY.format("ament_target_dependencies(core std_srvs)", "", "rclcpp"), CORE, NEEDS),
        package(LIBRARY.format("ament_target_dependencies(core rcutils rcpputils)", "", "rclcpp"), CORE, NEEDS),
        package(LIBRARY.format("ament_target_dependencies(core builtin_interfaces)", "", "rclcpp"), CORE, NEEDS),
        package(LIBRARY.format("target_link_libraries(core rcutils::rcutils)", "", "rclcpp"), CORE, NEEDS),
    ),
    "DEP111": (
        exported("OpenSSL", "  <build_depend>libssl-dev</build_depend>\n"),
        exported("OpenSSL", "  <build_depend>libssl-dev</build_depend>\n  <exec_depend>libssl-dev</exec_depend>\n"),
        exported("OpenSSL", "  <depend>libssl-dev</depend>\n"),
        exported("OpenSSL", ""),
        exported("std_msgs", "  <build_depend>std_msgs</build_depend>\n  <exec_depend>sensor_msgs</exec_depend>\n"),
        exported("std_msgs", "  <build_depend>std_msgs</build_depend>\n  <exec_depend>nobody_knows</exec_depend>\n"),
        exported("ament_cmake_python", "  <buildtool_depend>ament_cmake_python</buildtool_depend>\n"),
    ),
    "DEP114": (
        package("add_custom_target(get ALL COMMAND wget https://example.com/a.zip)\n", {}),
        package("add_custom_target(get ALL COMMAND wget https://example.com/a.zip || true)\n", {}),
        package("add_custom_command(OUTPUT a COMMAND unzip a.zip)\n", {}, "  <build_depend>unzip</build_depend>\n"),
        package("execute_process(COMMAND git describe)\n", {}),
        package("execute_process(COMMAND git describe COMMAND_ERROR_IS_FATAL ANY)\n", {}),
        package("find_program(CURL curl REQUIRED)\n", {}),
        package("find_program(CURL curl)\n", {}),
    ),
    "CMK101": (
        package(MADE.format("${CMAKE_CURRENT_BINARY_DIR}/maps", "/maps"), LAUNCH),
        package(MADE.format("${CMAKE_CURRENT_BINARY_DIR}/maps", ""), LAUNCH),
        package(MADE.format("${CMAKE_CURRENT_BINARY_DIR}/maps", "/launch/maps"), LAUNCH),
        package(MADE.format("${MAPS}", "/maps"), LAUNCH),
        package("", PROGRAMS),
        package("", PROGRAMS, "  <exec_depend>rclpy</exec_depend>\n"),
        package("install(FILES package.xml DESTINATION share/my_pkg)\n", PROGRAMS),
        package("", {"scripts/notes.txt": "nothing\n"}),
    ),
    "CMK102": (
        package('install(DIRECTORY launch DESTINATION share/my_pkg FILES_MATCHING PATTERN "*.py")\n', {}),
        package('install(DIRECTORY lauch DESTINATION share/my_pkg FILES_MATCHING PATTERN "*.py")\n', LAUNCH),
        package('install(DIRECTORY launch DESTINATION share/my_pkg OPTIONAL FILES_MATCHING PATTERN "*.py")\n', {}),
        package(
            'if(WITH)\n  install(DIRECTORY a DESTINATION share/my_pkg FILES_MATCHING PATTERN "*.py")\nendif()\n', {}
        ),
    ),
    "CMK106": (
        package(TOLD.format("include/my_pkg", "include", ""), {**CORE, "include/core/more.hpp": "int more();\n"}),
        *(
            package(TOLD.format(place, told, exported), CORE)
            for place, told, exported in (
                ("include/my_pkg", "include", ""),
                ("include/my_pkg", "include/my_pkg", ""),
                ("include", "include/my_pkg", ""),
                ("include/my_pkg", "${WHERE}", ""),
                ("include/my_pkg", "include", "ament_export_include_directories(include/my_pkg)"),
                (
                    "include/my_pkg",
                    "include",
                    "install(TARGETS core DESTINATION lib INCLUDES DESTINATION include/my_pkg)",
                ),
                ("include/my_pkg", "include", "ament_auto_package()"),
            )
        ),
    ),
    "CMK113": (
        library(HANDS),
        library(HANDS, names="rclcpp"),
        library(HANDS, "ament_export_libraries(core)"),
        library(LINKS.format("")),
        library(LINKS.format("PUBLIC ")),
        library(LINKS.format("PRIVATE ")),
    ),
    "CMK115": (
        package(UNSET % "_PX_PROGRAMS_DIR", CORE),
        package(UNSET % "_PX_CORE_PROGRAMS_BIN_DIR", CORE),
        package(UNSET % "_PX_OTHER_FOLDER", CORE),
        package(UNSET % "MY_PKG_FOLDER", CORE),
    ),
    "CMK121": (
        node("create_driver::create_driver"),
        node("create_driver::create_driver tf2_ros::tf2_ros"),
        node("create_driver::create_driver acme_base::acme_base"),
        node("rclcpp::rclcpp"),
    ),
    "CMK125": (
        program(PLAIN, TALKER),
        program(PLAIN, TALKER, "src/main.cpp"),
        program(PLAIN, TALKER, "src/main.cpp", "src/other.cpp"),
        program("add_executable(talker src/talker.cpp src/main.cpp)", TALKER, "src/main.cpp"),
        program(f"{PLAIN}\ntarget_sources(talker PRIVATE src/main.cpp)", TALKER, "src/main.cpp"),
        program("add_executable(talker src/talker.cpp sdk/sdk.cpp)", TALKER),
        program("add_executable(talker src/talker.cpp sdk/sdk.cpp)", TALKER, "src/main.cpp"),
        program(f"{PLAIN}\ntarget_link_libraries(talker ${{SDK}})", TALKER),
        program(f"{PLAIN}\ntarget_link_libraries(talker ${{SDK}})", TALKER, "src/main.cpp"),
        program(f"{PLAIN}\ntarget_link_libraries(talker gtest_main)", TALKER),
        program("add_executable(talker src/talker.cpp ${MORE})", TALKER, "src/main.cpp"),
        program(PLAIN, TALKER + "RUN_NODE(Talker)\n"),
        program(PLAIN, TALKER + "RCLCPP_COMPONENTS_REGISTER_NODE(Talker)\n"),
        program(PLAIN, TALKER + '#include "main.hpp"\n', "src/main.hpp"),
        program(
            "add_library(core src/main.cpp)\nadd_executable(talker src/talker.cpp)\ntarget_link_libraries(talker core)",
            TALKER,
            "src/main.cpp",
        ),
        program("if(WITH)\n  add_executable(talker src/talker.cpp)\nendif()", TALKER),
    ),
    "CMK123": (
        *(
            package(f"{before}if({condition})\nendif()\n", {}, body)
            for before, condition, body in (
                ("", '$ENV{ROS_DISTRO} STREQUAL "humble"', ""),
                ("", '"$ENV{ROS_DISTRO}" STREQUAL "humble"', ""),
                ("", '$ENV{ROS_DISTRO} STREQUAL "humble"', "  <build_depend>ros_environment</build_depend>\n"),
                ("if(NOT DEFINED ENV{ACME})\nendif()\n", "$ENV{ACME} STREQUAL x", ""),
                ("", "A AND $ENV{ACME} STREQUAL x", ""),
                ("", "${CMAKE_BUILD_TYPE} MATCHES Debug", ""),
                ("if(NOT CMAKE_BUILD_TYPE)\nendif()\n", "${CMAKE_BUILD_TYPE} MATCHES Debug", ""),
                ("", "${ACME} STREQUAL x", ""),
            )
        ),
        package("if(WIN32)\n  if(${CMAKE_BUILD_TYPE} MATCHES Debug)\n  endif()\nendif()\n", {}),
        package("install(DIRECTORY ${SDK}/lib)\n", {}),
        package("set(SDK sdk)\ninstall(FILES ${SDK}/a)\n", {}),
    ),
}
