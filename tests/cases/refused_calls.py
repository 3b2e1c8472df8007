"""Sentences and silences about calls that CMake refuses, and about libraries that export nothing."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example
from rospkg_cli.rules.plugins import plg007_unexported_tree_nodes as plg007

SOURCES = {"src/core.cpp": "int core() {return 1;}\n", "launch/a.launch.xml": "<launch/>\n", "plugin.xml": "<class/>\n"}
CORE = "add_library(core SHARED src/core.cpp)\ninstall(TARGETS core DESTINATION lib)\n"


def package(lines: str, files: dict[str, str] | None = None) -> Example:
    """A CMake package with a library and some lines more."""
    text = CMAKE.replace("ament_package", f"{CORE}{lines}\nament_package")
    return Example(bad={"CMakeLists.txt": text, **SOURCES, **(files or {})}, good={}, on="ament_cmake")


NODES = plg007.SOURCE.replace("«", "").replace("»", "")


def nodes(lines: str, source: str = NODES) -> Example:
    """A package with nodes of a behavior tree, and what CMake makes of them."""
    text = CMAKE.replace("ament_package", f"{lines}\nament_package")
    files = {"CMakeLists.txt": text, "package.xml": plg007.NEEDS, "src/wait.cpp": source}
    return Example(bad=files, good={}, on="ament_cmake")


SHARED = "add_library(wait_node MODULE src/wait.cpp)\ninstall(TARGETS wait_node DESTINATION lib)"
CASES = {
    "PLG007": (
        nodes(SHARED),
        nodes(f"add_definitions(-DBT_PLUGIN_EXPORT)\n{SHARED}"),
        nodes(SHARED, "#define BT_PLUGIN_EXPORT\n" + NODES),
        nodes(SHARED, NODES + "void use(BT::BehaviorTreeFactory & factory) {BT_RegisterNodesFromPlugin(factory);}\n"),
        nodes(SHARED, NODES.replace("BT_REG", "#ifdef WITH_NODES\nBT_REG") + "#endif\n"),
        nodes(f"include(${{team_DIR}}/team.cmake)\n{SHARED}"),
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
