"""Sentences about CMakeLists.txt that no example shows."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest
from rospkg_cli.rules.cmake import cmk101_cmake_folder_not_installed as cmk101
from rospkg_cli.rules.cmake import cmk104_wrong_executable_destination as cmk104
from rospkg_cli.rules.cmake import cmk105_script_not_executable as cmk105
from rospkg_cli.rules.cmake import cmk110_unknown_target as cmk110

MAIN = "int main() {return 0;}\n"
NODE = "#include <rclcpp/rclcpp.hpp>\nint main(int c, char ** v) {rclcpp::init(c, v); rclcpp::spin(nullptr);}\n"


BIN = cmk104.BOTH.replace("«", "").replace("»", "")


def cmake(lines: str, package: str = "", **files: str) -> Example:
    """A CMake package with some lines more; `__` in the name of a file is `/`, and one `_` before `hpp` … a dot."""
    named = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in files.items()}
    bad = {"CMakeLists.txt": CMAKE.replace("ament_package", lines + "ament_package"), **named}
    if package:
        bad["package.xml"] = manifest(package, "ament_cmake")
    return Example(bad=bad, good={}, on="ament_cmake")


def called(project: str, name: str) -> Example:
    """A package of some name with another name for its project."""
    files = {
        "CMakeLists.txt": CMAKE.replace("project(my_pkg)", project),
        "package.xml": manifest(build_type="ament_cmake", name=name),
    }
    return Example(bad=files, good={}, on="ament_cmake")


SUPERBUILD = """\
option({0} "" ON)
if({0})
  project(superbuild NONE)
  ExternalProject_Add(own SOURCE_DIR {1} CMAKE_ARGS -D{0}={2})
  return()
endif()
project(my_pkg)"""

LIBRARY = "add_library(core SHARED src/core.cpp)\n"
EXPORTED = "install(TARGETS core EXPORT core_targets DESTINATION lib)\nament_export_targets(core_targets)\n"

TALKER = (
    "find_package(rclcpp REQUIRED)\nadd_executable(talker src/talker.cpp)\n"
    "install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
)
NEEDS_RCLCPP = "  <depend>rclcpp</depend>\n"
GTEST = "find_package(ament_cmake_gtest REQUIRED)\n"
NEEDS_GTEST = "  <test_depend>ament_cmake_gtest</test_depend>\n"

OLD = {
    "old/package.xml": manifest(build_type="ament_cmake", name="old"),
    "old/CMakeLists.txt": CMAKE.replace("my_pkg", "old"),
}
"""A package that exports no target."""
USER = {
    "user/package.xml": manifest("  <depend>old</depend>\n", "ament_cmake"),
    "user/CMakeLists.txt": CMAKE.replace(
        "ament_package",
        "find_package(old REQUIRED)\nadd_executable(talker src/a.cpp)\nament_target_dependencies(talker old)\n"
        "install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\nament_package",
    ),
    "user/src/a.cpp": MAIN,
}

LINKS_OLD = USER["user/CMakeLists.txt"].replace(
    "ament_target_dependencies(talker old)", "target_link_libraries(talker old::old)"
)
END = "ament_package()\n"
EXPORTS_RCLPCP = "find_package(rclcpp REQUIRED)\nament_export_dependencies(rclpcp)\n"

COMPONENT = 'rclcpp_components_register_nodes(core "my_pkg::Core")\n'

CASES = {
    "CMK001": (
        called("project(other)", "my pkg"),
        called("set(NAME other)\nproject(${NAME})", "my_pkg"),
        called("if(SUPER)\n  project(SUPER NONE)\n  return()\nelse()\n  project(my_pkg)\nendif()", "my_pkg"),
        called("if(FALSE)\n  project(my_pkg)\nendif()\nproject(other)", "my_pkg"),
        called("if(SUPER)\n  project(other)\nendif()", "my_pkg"),
        *(called(SUPERBUILD.format(option, place, off), "mypkg")
          for option, place, off in (("USE_SUPERBUILD", "${PROJECT_SOURCE_DIR}", "OFF"),
                                     ("USE_SUPERBUILD", '"${CMAKE_CURRENT_SOURCE_DIR}"', "0"),
                                     ("USE_SUPERBUILD", "${PROJECT_SOURCE_DIR}", "ON"),
                                     ("USE_SUPERBUILD", "${PROJECT_BINARY_DIR}", "OFF"),
                                     ("USE_OTHERS", "${PROJECT_SOURCE_DIR}", "OFF"))),
        called("project(first)\nproject(other)", "my_pkg"),
        called("project(other)\nif(FALSE)\n  project()\nendif()", "my_pkg"),
        Example(bad={"CMakeLists.txt": "project(other)\n"}, good={}, on="ament_cmake"),
    ),
    "CMK002": (
        Example(bad={"CMakeLists.txt": CMAKE.replace("3.20", "3.5")}, good={}, on="ament_cmake", targets=("lyrical",)),
        Example(bad={"CMakeLists.txt": CMAKE.replace("3.20", "3.4")}, good={}, on="ament_cmake"),
        *(Example(bad={"CMakeLists.txt": first + CMAKE.partition("\n")[2] + last}, good={}, on="ament_cmake")
          for first, last in (("", ""), ("cmake_minimum_requierd(VERSION 3.20)\n", ""), ("include(a.cmake)\n", ""),
                              ("include(${A}/a.cmake)\n", ""), ("", "return()\n"))),
        Example(bad={"CMakeLists.txt": "project(my_pkg)\n"}, good={}, on="ament_cmake"),
    ),
    "CMK003": tuple(
        Example(bad={"CMakeLists.txt": f"{CMAKE.removesuffix(END)}{line}\n"}, good={}, on="ament_cmake")
        for line in ("team_package()", "extract_package_metadata(pkg)", "include(${team_DIR}/a.cmake)",
                     "ament_python_install_package(a)", "project(b)")
    ),
    "CMK005": (
        cmake("add_executable(talker src/a.cpp)\nament_target_dependencies(talker ${PACKAGES_OF_ANOTHER_FILE})\n",
              src__a_DOT_cpp=MAIN),
        Example(bad={**OLD, **USER}, good={}, on=""),
        cmake("find_package(rclcpp REQUIRED)\nadd_executable(talker src/a.cpp)\nadd_executable(listener src/a.cpp)\n"
              "target_link_libraries(talker m)\ntarget_link_libraries(listener PUBLIC m)\n"
              "foreach(each talker listener)\n  ament_target_dependencies(${each} rclcpp)\nendforeach()\n",
              "  <depend>rclcpp</depend>\n", src__a_DOT_cpp=MAIN),
    ),
    "CMK006": (cmake("add_executable(talker src/a.cpp)\nadd_library(talker src/a.cpp)\n", src__a_DOT_cpp=MAIN),),
    "CMK101": (
        cmake("", config__words_DOT_toml="a = 1\n", robot_description__base_DOT_xacro="<robot name='a'/>\n"),
        cmake("install(DIRECTORY meshes DESTINATION share/${PROJECT_NAME}/more)\n"
              "install(FILES LICENSE DESTINATION share/${PROJECT_NAME})\n",
              LICENSE="Apache License\n", **cmk101.MESHES),
        cmake('install(DIRECTORY "launch" DESTINATION share/${PROJECT_NAME})\n',
              config__a_DOT_yaml="a: 1\n", launch__a_DOT_launch_DOT_xml="<launch>\n</launch>\n"),
    ),
    "CMK102": (
        cmake("install(FILES missing.yaml DESTINATION share/${PROJECT_NAME})\n"),
        cmake("install(FILES LICENCE DESTINATION share/${PROJECT_NAME})\n"),
        cmake("find_package(pluginlib REQUIRED)\npluginlib_export_plugin_description_file(nav2_core plugns.xml)\n"),
        cmake("if(SOMETHING_ELSE)\n  add_executable(talker src/a.cpp)\nendif()\n"),
        cmake("if(SOMETHING_ELSE)\n  add_subdirectory(tets)\n  add_subdirectory(more)\n"
              "  ament_add_pytest_test(a tests/tset_a.py)\n"
              "  install(DIRECTORY tets other DESTINATION share/x)\n"
              "  install(FILES tests/test_b.py DESTINATION share/x)\nendif()\n",
              tests__CMakeLists_DOT_txt="", tests__test_a_DOT_py=""),
        cmake(f"if(BUILD_TESTING)\n  {GTEST}  ament_add_gtest(test_a TIMEOUT 60 test/a.cpp ENV a=b)\n"
              "  ament_add_gmock(test_b SKIP_TEST test/b.cpp)\nendif()\n"),
        cmake("if(BUILD_TESTING)\n  find_package(launch_testing_ament_cmake REQUIRED)\n"
              "  add_launch_test(test/talker_launch.py TIMEOUT 60)\nendif()\n"),
        cmake("find_package(generate_parameter_library REQUIRED)\n"
              "generate_parameter_library(talker_parameters src/talker.yaml)\n"
              "generate_parameter_module(listener_parameters src/listener.yaml)\n"),
        cmake("execute_process(COMMAND make_tests ${CMAKE_CURRENT_SOURCE_DIR})\nif(BUILD_TESTING)\n"
              "  ament_add_pytest_test(test_a test/test_a.py)\nendif()\n"),
    ),
    "CMK103": (
        cmake("add_library(core SHARED src/a.cpp)\nadd_library(base SHARED src/a.cpp)\n"
              "target_link_libraries(core PUBLIC base)\ninstall(FILES core DESTINATION lib)\n"
              "install(TARGETS core\n  DESTINATION lib\n)\n", src__a_DOT_cpp=MAIN, core="a file of that name\n"),
        cmake(f"{LIBRARY}add_library(base SHARED src/base.cpp)\ntarget_link_libraries(core PUBLIC base)\n{EXPORTED}",
              src__core_DOT_cpp="int core() {return 1;}\n", src__base_DOT_cpp="int base() {return 1;}\n"),
        *(cmake(f"{each}{LIBRARY}add_library(base SHARED src/base.cpp)\ntarget_link_libraries(core PUBLIC base)\n"
                "install(TARGETS core DESTINATION lib)\n",
                src__core_DOT_cpp="int core() {return 1;}\n", src__base_DOT_cpp="int base() {return 1;}\n")
          for each in ("", 'set(CMAKE_INSTALL_RPATH "${PROJECT_BINARY_DIR}")\n',
                       'set(CMAKE_INSTALL_RPATH "$ORIGIN")\nset(other ${PROJECT_BINARY_DIR})\n')),
    ),
    "CMK104": (
        cmake(BIN, src__talker_DOT_cpp=MAIN, src__core_DOT_cpp="int core();\n"),
        cmake(f"find_package(rclcpp REQUIRED)\n{BIN}target_link_libraries(talker rclcpp::rclcpp)\n",
              "  <depend>rclcpp</depend>\n", src__talker_DOT_cpp=NODE, src__core_DOT_cpp="int core();\n"),
    ),
    "CMK105": (
        cmake(cmk105.PROGRAMS.replace("«", "").replace("»", ""), scripts__hello_DOT_py="print('hello')\n"),
    ),
    "CMK106": (
        *(cmake(f"find_package(rclcpp_components REQUIRED)\n{LIBRARY}{each}{EXPORTED}",
                include__my_pkg__a_DOT_hpp="#pragma once\n", src__core_DOT_cpp="int core() {return 1;}\n",
                src__base_DOT_cpp="int base() {return 1;}\n")
          for each in ("", COMPONENT, f"{COMPONENT}add_library(base SHARED src/base.cpp)\n")),
        cmake("ament_export_include_directories(include)\n", include__my_pkg__a_DOT_hpp="#pragma once\n"),
    ),
    "CMK107": (
        cmake(f"{GTEST}ament_add_gtest(test_a test/a.cpp)  # fast\n", NEEDS_GTEST, test__a_DOT_cpp=MAIN),
    ),
    "CMK120": (
        cmake("if(WITH_MORE)\n  install(FILES LICENSE DESTINTION share/x)\nendif()\n"),
        cmake("install(DIRCTORY launch DESTNATION share/x)\ninstall(files LICENSE DESTINATION share/x)\n"),
        cmake("install(${FORM} a DESTINATION x)\ninstall(CODE a)\ninstall(SNACKS a DESTINATION x)\n"),
        cmake("set(TO DESTINTION)\ninstall(FILES package.xml ${TO} share/x)\n"),
    ),
    "CMK122": (
        cmake(
            "add_executable(talker src/talker.cpp)\ntarget_link_libraries(talker m)\n"
            "if(OpenMP_FOUND)\n  target_link_libraries(talker PUBLIC OpenMP::OpenMP_CXX)\nendif()\n",
            src__talker_DOT_cpp=MAIN,
        ),
    ),
    "CMK110": (
        *(cmake(f"{first}add_executable(talker src/a.cpp)\n{last}", src__a_DOT_cpp=MAIN)
          for first, last in (
              ("target_link_libraries(talker m)\ntarget_include_directories(talker PUBLIC include)\n", ""),
              ("install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n", ""),
              ("if(UNKNOWN_ONE)\n  target_link_libraries(talker m)\nendif()\n", ""),
              ("someones_macro(talker)\ntarget_link_libraries(talker m)\n", ""),
              ("macro(link)\n  target_link_libraries(talker m)\nendmacro()\n", "link()\n"),
              ("include(${OTHER}/a.cmake)\ntarget_link_libraries(talker m)\n", ""),
          )),
        cmake("find_package(rclcpp REQUIRED)\nfind_package(std_msgs REQUIRED)\n"
              "ament_export_dependencies(rclcppstd_msgs)\n",
              "  <depend>rclcpp</depend>\n  <depend>std_msgs</depend>\n"),
        cmake("install(TARGETS nothing DESTINATION lib/${PROJECT_NAME})\n"),
        Example(bad={**OLD, **USER, "user/CMakeLists.txt": LINKS_OLD.replace("old::old)", "old::old old::old)")},
                good={}, on=""),
        cmake("add_executable(talker src/talker.cpp)\ninstall(TARGETS talkr DESTINATION lib/${PROJECT_NAME})\n",
              src__talker_DOT_cpp=cmk110.SOURCE),
        cmake("set_target_properties(talkr PROPERTIES CXX_STANDARD 17)\n"),
        *(cmake(f"add_library(talker_core SHARED src/core.cpp)\n{lines}", src__core_DOT_cpp="int core() {return 1;}\n")
          for lines in (
              "if(WITH_MORE)\n  target_compile_options(talker_croe PRIVATE -w)\nendif()\n",
              "if(WITH_MORE)\n  target_compile_options(listener PRIVATE -w)\nendif()\n",
              "if(WITH_MORE)\n  target_compile_options(talker_core2 PRIVATE -w)\nendif()\n",
              "add_library(talker_a SHARED src/core.cpp)\nif(X)\n  target_compile_options(talker_b PUBLIC)\nendif()\n",
              "add_library(talker_a SHARED src/core.cpp)\nif(X)\n  target_link_libraries(talker_a talker_b)\nendif()\n",
              "add_library(${MORE}_x SHARED src/core.cpp)\ntarget_compile_options(talker_croe PRIVATE -w)\n",
              "add_library(${MORE}_x SHARED src/core.cpp)\ntarget_compile_options(listener PRIVATE -w)\n",
              "include(${OTHER}/a.cmake)\ntarget_compile_options(talker_croe PRIVATE -w)\n",
              "include(${OTHER}/a.cmake)\ntarget_compile_options(listener PRIVATE -w)\n",
              "add_library(other SHARED src/core.cpp)\ninclude(${OTHER}/a.cmake)\n"
              "target_link_libraries(other PRIVATE talker_croe)\n",
              "add_library(cores SHARED src/core.cpp)\ninclude(${OTHER}/a.cmake)\n"
              "target_link_libraries(talker_core PRIVATE coers)\ntarget_compile_options(coers PRIVATE -w)\n",
          )),
        cmake(f"{TALKER}target_link_libraries(talker rclcp::rclcpp)\n", NEEDS_RCLCPP, src__talker_DOT_cpp=MAIN),
        cmake(f"{LIBRARY}add_library(my_pkg::core ALIAS core)\nadd_library(base SHARED src/core.cpp)\n"
              "target_link_libraries(base PUBLIC my_pkg::croe)\n", src__core_DOT_cpp="int core() {return 1;}\n"),
    ),
    "CMK111": (
        cmake("install(FILES LICENSE DESTINATION /usr/share/my_pkg)\n"),
        cmake("install(FILES LICENSE DESTINATION /opt/ros/humble/share/my_pkg)\n"),
        cmake("install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_PREFIX}/share/my_pkg)\n"),
        cmake("install(FILES LICENSE DESTINATION /etc/my_pkg)\n"),
    ),
    "CMK114": (
        Example(
            bad={
                "CMakeLists.txt": CMAKE.replace("find_package(ament_cmake", "find_package(rclcpp"),
                "package.xml": manifest(NEEDS_RCLCPP, "ament_cmake"),
            },
            good={},
            on="ament_cmake",
        ),
        cmake("ament_add_gtest(test_a test/a.cpp)\n", NEEDS_GTEST, test__a_DOT_cpp=MAIN),
    ),
    "CMK117": (
        cmake("find_package(rclcpp REQUIRED)\nadd_executable(talker src/a.cpp)\n"
              "ament_target_dependencies(talker rclpcp)\n", NEEDS_RCLCPP, src__a_DOT_cpp=MAIN),
        cmake(f"{LIBRARY}add_executable(talker src/a.cpp)\nament_target_dependencies(talker PUBLIC core)\n"
              "ament_export_dependencies(core)\n", src__a_DOT_cpp=MAIN, src__core_DOT_cpp=MAIN),
        Example(
            bad={**OLD, "old/CMakeLists.txt": OLD["old/CMakeLists.txt"].replace(END, f"{EXPORTS_RCLPCP}{END}"), **USER},
            good={}, on=""),
        *(cmake(f"find_package({name} REQUIRED)\n")
          for name in ("ament_cmkae_ros", "acme_cmake_rso", "gemetry_msgs", "geometry_mssg")),
    ),
    "CMK109": (
        cmake("find_package(ament_cmake_python REQUIRED)\n",
              "  <buildtool_depend>ament_cmake_python</buildtool_depend>\n",
              my_pkg____init___DOT_py="", my_pkg__words_DOT_py="WORD = 'a'\n"),
    ),
    "CMK202": (
        *(cmake(f"{lines}add_library(part SHARED src/core.cpp)\ninstall(TARGETS part DESTINATION lib)\n",
                src__core_DOT_cpp="int core() {return 1;}\n",
                src__part_DOT_cpp="RCLCPP_COMPONENTS_REGISTER_NODE(my_pkg::Part)\n")
          for lines in ("", "add_library(other src/part)\n", "# src/part.cpp\n",
                        "set(SOURCES src/${NAME}.cpp)\n", "file(GLOB ALL src/*.cpp)\n")),
        cmake("add_library(core SHARED src/core.cpp)\ninstall(TARGETS core DESTINATION lib)\n",
              src__core_DOT_cpp="int core() {return 1;}\n",
              src__part_DOT_cpp="RCLCPP_COMPONENTS_REGISTER_NODE(my_pkg::Part)\n"),
    ),
    "CMK201": (
        *(cmake(f"{lines}add_executable(talker src/a.cpp)\n", src__a_DOT_cpp=f"#include <my_pkg/words.hpp>\n{MAIN}",
                include__my_pkg__words_DOT_hpp="#pragma once\n", **more)
          for lines, more in (
              ("", {}),
              ("add_executable(listener src/b.cpp)\n", {"src__b_DOT_cpp": f"#include <my_pkg/words.hpp>\n{MAIN}"}),
              ("ament_export_include_directories(include)\n", {}),
              ("include_directories(src)\n", {}),
              ("set(CMAKE_CXX_FLAGS -Iinclude)\n", {}),
              ("someones_macro(a)\n", {}),
              ("", {"lib__my_pkg__words_DOT_hpp": ""}),
          )),
        cmake("add_executable(talker src/a.cpp)\n", src__a_DOT_cpp=f'#include "my_pkg/words.hpp"\n{MAIN}',
              include__my_pkg__words_DOT_hpp="#pragma once\n", src__my_pkg__words_DOT_hpp="#pragma once\n"),
        cmake("add_executable(talker src/a.cpp)\n", include__my_pkg__words_DOT_hpp="#pragma once\n",
              src__a_DOT_cpp=f"#if A\n#include <my_pkg/words.hpp>\n#endif\n{MAIN}"),
        *(cmake("add_executable(talker src/a.cpp)\n", "  <depend>fleet_robot_msgs</depend>\n",
                src__a_DOT_cpp=f"#include <fleet_robot_msgs/msg/b.hpp>\n{more}#include <{name}/msg/a.hpp>\n{MAIN}")
          for name, more in (("fleet_roobt_msgs", "#include <fleet_robot_msgs/msg/c.hpp>\n"), ("fleet_roobt_msgs", ""),
                             ("other_robot_msgs", "#include <fleet_robot_msgs/msg/c.hpp>\n"))),
        cmake("find_package(rclcpp REQUIRED)\nadd_executable(talker src/a.cpp)\n", NEEDS_RCLCPP,
              include__my_pkg__a_DOT_hpp="#pragma once\n",
              src__a_DOT_cpp=f"#include <ros/ros.h>\n#include <my_pkg/Words.h>\n{MAIN}"),
        cmake("find_package(rclcpp REQUIRED)\nadd_executable(talker src/a.cpp)\n", NEEDS_RCLCPP,
              include__my_pkg__a_DOT_hpp="#pragma once\n", src__a_DOT_cpp=f"#include <my_pkg/Words.h>\n{MAIN}"),
        cmake("add_executable(talker src/a.cpp)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n",
              src__a_DOT_cpp='#include "hepler.hpp"\n#include "my_pkg/not_there.hpp"\nint main() {return 0;}\n',
              src__helper_DOT_hpp="#include <my_pkg/too.hpp>\n",
              include__my_pkg__b_DOT_hpp="#include <my_pkg/bb.hpp>\n"),
        *(cmake(lines, src__a_DOT_cpp=MAIN, src__more_DOT_cpp="#include <my_pkg/bb.hpp>\n",
                include__my_pkg__b_DOT_hpp="#pragma once\n")
          for lines in ("add_executable(talker src/a.cpp)\nif(WITH_MORE)\n  add_executable(b src/more.cpp)\nendif()\n",
                        "add_executable(talker src/a.cpp)\nif(BUILD_TESTING)\n  add_executable(b src/more.cpp)\n"
                        "endif()\n", "add_executable(talker ${WHATEVER})\n")),
        cmake("", include__my_pkg__b_DOT_hpp="#include <my_pkg/bb.hpp>\n"),
    ),
    "CMK118": (
        *(cmake(f"{before}add_library(robot_core_base SHARED src/a.cpp)\n"
                "install(TARGETS robot_core_base DESTINATION lib)\n"
                f"ament_export_libraries({name})\n", src__a_DOT_cpp="int a() {return 0;}\n")
          for before in ("", "FetchContent_MakeAvailable(other)\n")
          for name in ("robot_core_bsae", "robot_core_face", "my_pkg", "robot_core_base")),
        Example(
            bad={**OLD, "old/src/a.cpp": MAIN,
                 "old/CMakeLists.txt": OLD["old/CMakeLists.txt"].replace(
                     END, f"add_executable(tool src/a.cpp)\nament_export_libraries(tool old)\n{END}"), **USER},
            good={}, on=""),
    ),
    "CMK115": (
        cmake("add_executable(talker src/a.cpp)\ninstall(TARGETS talker ${LIBRARIES}\n"
              "  DESTINATION lib/${PROJECT_NAME})\n", src__a_DOT_cpp=MAIN),
        cmake("find_package(std_msgs REQUIRED)\ninclude_directories(${STD_MSGS_INCLUDE_DIRS})\n",
              "  <depend>std_msgs</depend>\n"),
        *(Example(bad={**OLD, "old/package.xml": manifest(build_type=made_by, name="old"), **USER,
                       "user/CMakeLists.txt": USER["user/CMakeLists.txt"].replace(
                           END, "include_directories(${OLD_INCLUDE_DIRS})\n" + END)}, good={}, on="")
          for made_by in ("ament_cmake", "cmake")),
        cmake('include_directories("${CMAKE_CURENT_SOURCE_DIR}/include")\n'),
    ),
}  # fmt: skip
