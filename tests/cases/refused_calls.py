"""Sentences and silences about calls that CMake refuses, and about libraries that export nothing."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest
from rospkg_cli.rules.plugins import plg007_unexported_tree_nodes as plg007

SOURCES = {"src/core.cpp": "int core() {return 1;}\n", "launch/a.launch.xml": "<launch/>\n", "plugin.xml": "<class/>\n"}
CORE = "add_library(core SHARED src/core.cpp)\ninstall(TARGETS core DESTINATION lib)\n"


def package(lines: str, files: dict[str, str] | None = None) -> Example:
    """A CMake package with a library and some lines more."""
    text = CMAKE.replace("ament_package", f"{CORE}{lines}\nament_package")
    return Example(bad={"CMakeLists.txt": text, **SOURCES, **(files or {})}, good={}, on="ament_cmake")


NODES = plg007.SOURCE.replace("«", "").replace("»", "")


def nodes(lines: str, source: str = NODES, main: str = "") -> Example:
    """A package with nodes of a behavior tree, and what CMake makes of them."""
    text = CMAKE.replace("ament_package", f"{lines}\nament_package")
    files = {"CMakeLists.txt": text, "package.xml": plg007.NEEDS, "src/wait.cpp": source, "src/main.cpp": main}
    return Example(bad=files, good={}, on="ament_cmake")


def globbed(lines: str, **files: str) -> Example:
    """A package whose sources CMake looks for, with more files; `__` in the name of a file is `/`."""
    named = {name.replace("__", "/") + ".cpp": text for name, text in files.items()}
    text = CMAKE.replace("ament_package", f"{lines}\nadd_library(core SHARED ${{SOURCES}})\nament_package")
    return Example(bad={"CMakeLists.txt": text, "src/core/a.cpp": CODE, **named}, good={}, on="ament_cmake")


CODE = "int core() {return 1;}\n"
SHARED = "add_library(wait_node MODULE src/wait.cpp)\ninstall(TARGETS wait_node DESTINATION lib)"
TESTED = """\
if(BUILD_TESTING)
  find_package(ament_cmake_gtest REQUIRED)
  ament_add_gtest(test_core test/test_core.cpp)
  {}
endif()
{}
"""


def tested(inside: str, outside: str) -> Example:
    """A package with a test, and what is said of it inside and outside of `if(BUILD_TESTING)`."""
    files = {
        "package.xml": manifest("  <test_depend>ament_cmake_gtest</test_depend>\n", "ament_cmake"),
        "test/test_core.cpp": "int main() {return 0;}\n",
    }
    return package(TESTED.format(inside, outside), files)


LINKED = "target_link_libraries(test_core core)"
ROBOT = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="$(find my_pkg)/{}/arm.xacro"/>
  <link name="base"/>
</robot>
"""


def robot(folder: str, *installed: str) -> Example:
    """A robot that includes a file of another folder of its package."""
    text = CMAKE.replace(
        "ament_package", f"install(DIRECTORY {' '.join(installed)} DESTINATION share/my_pkg)\nament_package"
    )
    included = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"/>\n'
    files = {"CMakeLists.txt": text, "urdf/arm.urdf.xacro": ROBOT.format(folder), f"{folder}/arm.xacro": included}
    return Example(bad=files, good={}, on="ament_cmake")


def world(text: str, opened: str = "") -> Example:
    """A package with a world that a launch file may open."""
    launch = f"from ament_index_python.packages import get_package_share_path\n\n{opened}\n"
    files = {"worlds/room.world": text, "launch/a.launch.py": launch + "def generate_launch_description(): ...\n"}
    return Example(bad=files, good={}, on="ament_python")


OWN = "add_library(my_pkg SHARED src/core.cpp)\ninstall(TARGETS my_pkg DESTINATION lib)\n"
OWN += "ament_target_dependencies(core ${PROJECT_NAME})"
OPENED = "load(get_package_share_path('my_pkg') / 'worlds' / 'room.world')"
CASES = {
    "RPK001": (
        world('<sdf version="1.6">\n  <world name="a">\n</sdf>\n', OPENED),
        world('<sdf version="1.6">\n  <world name="a">\n</sdf>\n'),
        world('<sdf version="1.6">\n  <world name="a"/>\n', OPENED),
        world('<sdf version="1.6">\n  <!-- a -- b -->\n</sdf>\n', OPENED),
    ),
    "URD002": (robot("control", "urdf"), robot("control", "urdf", "control"), robot("xacro", "urdf")),
    "CMK107": (
        tested("", LINKED),
        tested(LINKED, "target_link_libraries(core m)"),
        tested("", f"if(TARGET test_core)\n  {LINKED}\nendif()"),
        tested("", f"if(WITH_MORE)\n  {LINKED}\nendif()\nfunction(more)\n  {LINKED}\nendfunction()\nmore()"),
        tested("else()\n  add_library(test_core src/core.cpp)", LINKED),
        tested("", f"include(${{team_DIR}}/team.cmake)\n{LINKED}"),
    ),
    "CMK115": tuple(map(package, (
        "target_link_libraries(${node_name} m)\nament_target_dependencies(${node_name} rclcpp)",
        "if(WITH_MORE)\n  target_link_libraries(${node_name} m)\nendif()",
        "rosidl_generate_interfaces(${PROJECT_NAME} ${ALL_MESSAGES} DEPENDENCIES ${MESSAGE_PACKAGES})",
        "rosidl_generate_interfaces(${PROJECT_NAME} ${ALL_MESSAGES} msg/A.msg)",
        "set_names(node_name)\ntarget_link_libraries(${node_name} m)",
    ))),
    "CMK117": tuple(map(package, (
        OWN,
        OWN.replace("_library(my_pkg", "_library(other"),
        "set(${PROJECT_NAME}_FOUND TRUE)\n" + OWN,
        "find_package(my_pkg)\n" + OWN,
        "ament_target_dependencies(core my_pkg)",
    ))),
    "CMK124": (
        globbed("file(GLOB SOURCES src/*.cpp)"),
        globbed("file(GLOB MORE src/*.cpp)\nset(SOURCES src/core/a.cpp ${MORE})"),
        globbed('file(GLOB SOURCES CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR} "${CMAKE_SOURCE_DIR}/src/?.cpp")'),
        globbed("file(GLOB_RECURSE SOURCES src/*.cpp)"),
        globbed("file(GLOB SOURCES src/*.cpp)\nif(NOT SOURCES)\n  list(APPEND SOURCES src/core/a.cpp)\nendif()"),
        globbed("file(GLOB_RECURSE SOURCES *.cpp)"),
        globbed("file(GLOB_RECURSE SOURCES lib/*.cpp)"),
        globbed("file(GLOB SOURCES src/*.cpp)", test__b=CODE),
        globbed("file(GLOB SOURCES lib/core/*.cpp)", test__b=CODE),
        globbed("file(GLOB SOURCES src/*.cpp src/core/*.cpp)"),
        globbed("file(GLOB SOURCES src/*.hpp)\nfile(GLOB UNUSED src/*.cpp)\nfile(WRITE SOURCES src/*.cpp)"),
        globbed("if(WITH_MORE)\n  file(GLOB SOURCES src/*.cpp)\nendif()"),
        globbed("file(GLOB SOURCES ${CMAKE_BINARY_DIR}/*.cpp)\nfile(GLOB SOURCES src/[ab].cpp)"),
        Example(
            bad={
                "CMakeLists.txt": CMAKE.replace("ament_package", "add_subdirectory(src)\nament_package"),
                "src/CMakeLists.txt": "file(GLOB SOURCES src/*.cpp)\nadd_library(core SHARED ${SOURCES})\n",
                "src/a.cpp": CODE,
                ".old/src/b.cpp": CODE,
            },
            good={},
            on="ament_cmake",
        ),
    ),
    "PLG007": (
        nodes(SHARED),
        nodes(f"add_definitions(-DBT_PLUGIN_EXPORT)\n{SHARED}"),
        nodes(SHARED, "#define BT_PLUGIN_EXPORT\n" + NODES),
        nodes(SHARED, NODES + "void use(BT::BehaviorTreeFactory & factory) {BT_RegisterNodesFromPlugin(factory);}\n"),
        nodes(SHARED, NODES.replace("BT_REG", "#ifdef WITH_NODES\nBT_REG") + "#endif\n"),
        nodes(f"include(${{team_DIR}}/team.cmake)\n{SHARED}"),
        nodes(SHARED, main='int main() {BT::BehaviorTreeFactory factory; factory.registerNodeType<Wait>("Wait");}\n'),
        nodes(SHARED, main='int main() {BT::BehaviorTreeFactory factory; factory.registerFromPlugin("a.so");}\n'),
        nodes(SHARED, main='int main() {BT::BehaviorTreeFactory f; f.registerFromPlugin("libwait_node.so");}\n'),
        nodes(SHARED, main='#include "wait_node/wait_node.hpp"\nint main() {return 0;}\n'),
        nodes(SHARED.replace("MODULE", "STATIC")),
        nodes("add_executable(wait_node src/wait.cpp)\ninstall(TARGETS wait_node DESTINATION lib/my_pkg)"),
    ),
    "CMK123": tuple(map(package, (
        "target_include_directories(core SYSTEM src)\ntarget_include_directories(core SYSTEM PUBLIC src)",
        "target_compile_definitions(core SOME=1)\ntarget_compile_definitions(core INTERFACE SOME=1)",
        "target_compile_options(core ${FLAGS_OF_TEAM} -Wall)\ntarget_compile_options(${SOME_TARGET} -Wall)",
        "if(WITH_MORE)\n  target_compile_options(core -Wall)\nendif()",
        "macro(target_sources target)\nendmacro()\ntarget_sources(core src/core.cpp)",
        "install(FILES plugin.xml)\ninstall(FILES plugin.xml TYPE DATA)\ninstall(FILES plugin.xml ${WHERE_TEAM})",
        "install(DIRECTORY launch)\ninstall(PROGRAMS launch/a.launch.xml)\ninstall(CODE x)",
        "install(DIRECTORY launch DIRECTORY src DESTINATION share/my_pkg)",
        'install(DIRECTORY launch "RUNTIME" DESTINATION share/my_pkg)\ninstall(FILES plugin.xml DESTINATION BUNDLE)',
        "install(DIRECTORY launch DESTINATION share/my_pkg FILES_MATCHING PATTERN LIBRARY)",
        "add_library(SHARED INTERFACE)\ntarget_link_libraries(core SHARED)",
        'target_link_libraries(core PUBLIC m REQUIRED "STATIC")',
        "pluginlib_export_plugin_description_file(plugin.xml)\npluginlib_export_plugin_description_file(a plugin.xml)",
        "generate_parameter_library(parameters)\ngenerate_parameter_library(${UNKNOWN_NAMES})",
        "if(WITH_MORE)\n  set(words BUNDLE)\nendif()\ninstall(FILES plugin.xml ${words} DESTINATION share/my_pkg)",
    ))),
}  # fmt: skip
