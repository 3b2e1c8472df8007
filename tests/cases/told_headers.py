"""Headers, libraries and scripts that a package lets nobody use: neighbours of what people repaired, and silences."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

INCLUDE = '#include "my_pkg/{}.hpp"\n'
FILES = {
    "src/core.cpp": INCLUDE.format("core") + "int core() {return 1;}\n",
    "include/my_pkg/core.hpp": "int core();\n",
}
HEADERS = "install(DIRECTORY include/ DESTINATION include)\n"
CORE = "add_library(core {}src/core.cpp)\n"
INSTALLED = "install(TARGETS core{} DESTINATION lib)\n"
LIBRARY = CORE.format("SHARED ") + INSTALLED.format("") + HEADERS
SET = CORE.format("SHARED ") + INSTALLED.format(" EXPORT core_targets") + HEADERS
TOLD = "target_include_directories(core PUBLIC $<INSTALL_INTERFACE:{}>)\n"
PLUGINS = "pluginlib_export_plugin_description_file(my_base plugins.xml)\n"
REGISTERED = FILES | {"src/core.cpp": FILES["src/core.cpp"] + "GZ_REGISTER_MODEL_PLUGIN(Core)\n"}
USER = {
    "user/package.xml": manifest("  <depend>my_pkg</depend>\n", "ament_cmake").replace("<name>my_pkg", "<name>user"),
    "user/CMakeLists.txt": CMAKE.replace("(my_pkg)", "(user)").replace(
        "ament_package", "find_package(my_pkg REQUIRED)\nadd_executable(user src/user.cpp)\nament_package"
    ),
    "user/src/user.cpp": INCLUDE.format("core") + "int main() {return core();}\n",
}
NODE = "#!/usr/bin/env python3\nimport rclpy\n\nif __name__ == '__main__':\n    rclpy.init()\n"
TOOL = NODE.replace("import rclpy", "import sys").replace("rclpy.init()", "sys.exit(1)")
CONFIG = "install(DIRECTORY config DESTINATION share/${PROJECT_NAME})\n"
CONFIGURED = {"config/a.yaml": "a: 1\n"}
TOOLED = CONFIGURED | {"scripts/make_maps.py": TOOL}
LINKED = "find_package({0} REQUIRED)\nadd_executable(talker src/talker.cpp)\ntarget_link_libraries(talker {1})\n"
MAIN = {"src/talker.cpp": "int main() {return 0;}\n"}
PUBLIC = CORE.format("SHARED ") + "target_include_directories(core {})\n{}" + INSTALLED.format(" EXPORT core_targets")
EXPORT = "ament_export_targets(core_targets)\n"


def package(lines: str, files: dict[str, str] = FILES, body: str = "", *targets: str) -> Example:
    text = CMAKE.replace("ament_package", lines + "ament_package")
    files = {"package.xml": manifest(body, "ament_cmake"), **files}
    return Example(bad={"CMakeLists.txt": text, **files}, good={}, on="ament_cmake", targets=targets)


def beside_user(lines: str, more: str = "") -> Example:
    own = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": CMAKE.replace("ament_package", lines + END)}
    user = USER | {"user/CMakeLists.txt": USER["user/CMakeLists.txt"].replace("ament_package", more + "ament_package")}
    files = {f"my_pkg/{path}": text for path, text in (own | FILES).items()}
    return Example(bad={**files, **user}, good={}, on="")


END = "ament_package"
REACHED = "target_include_directories(core {})\n"
PROGRAM = """\
add_executable(talker src/talker.cpp)
target_link_libraries(talker core)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
"""
OWN = FILES | {"src/talker.cpp": INCLUDE.format("core") + "int main() {return core();}\n"}
DEEP = FILES | {"include/my_pkg/core.hpp": INCLUDE.format("more"), "src/my_pkg/more.hpp": "int more();\n"}
WITH = DEEP | {"include/my_pkg/core.hpp": "#if WITH\n" + INCLUDE.format("more") + "#endif\n"}
WINDOW = FILES | {"include/my_pkg/core.hpp": '#include "ui_main.h"\n', "src/main.ui": "<ui/>\n"}
EXPORTED = "ament_export_include_directories(include)\nament_export_libraries(core)\n"
GENERATES = 'find_package(rosidl_default_generators REQUIRED)\nrosidl_generate_interfaces(my_pkg "msg/A.msg")\n'
INTERFACES = """\
  <buildtool_depend>rosidl_default_generators</buildtool_depend>
  <exec_depend>rosidl_default_runtime</exec_depend>
  <member_of_group>rosidl_interface_packages</member_of_group>
"""
USES = "#include <my_pkg/msg/a.hpp>\n"
GENERATED = {"msg/A.msg": "bool a\n", "src/talker.cpp": USES + "int main() {return 0;}\n"}
SWITCHED = GENERATED | {"src/talker.cpp": f"#if WITH\n{USES}#endif\nint main() {{return 0;}}\n"}
TWINS = {
    "src/talker.cpp": '#include "words.hpp"\nint main() {return 0;}\n',
    "src/words.hpp": "int words();\n",
    "test/words.hpp": "#include <std_msgs/msg/string.hpp>\n",
}
MESSAGES = "  <depend>std_msgs</depend>\n"
INDEXED = "find_package(rclcpp REQUIRED)\n" + PROGRAM.replace("talker core", "talker rclcpp::rclcpp")
SHARING = {
    "src/talker.cpp": "#include <ament_index_cpp/get_package_share_directory.hpp>\nint main() {return 0;}\n",
}
NODES = "  <depend>rclcpp</depend>\n  <depend>ament_index_cpp</depend>\n"
MODULE = (
    "find_package(pybind11 REQUIRED)\npybind11_add_module(fast src/fast.cpp)\ninstall(TARGETS fast DESTINATION {})\n"
)
MODULES = {"src/fast.cpp": "int fast() {return 1;}\n"}
HANDED = (
    "find_package(rclcpp REQUIRED)\n{}add_executable(talker src/talker.cpp)\nament_target_dependencies(talker {})\n"
)
CASES = {
    "CMK003": (
        Example(bad={"CMakeLists.txt": CMAKE.replace("ament_package", "autoware_package")}, good={}, on="ament_cmake"),
    ),
    "CMK104": (
        package(MODULE.format("lib/${PROJECT_NAME}"), MODULES),
        package(
            "find_package(ament_cmake_python REQUIRED)\nament_python_install_package(my_pkg)\n"
            + MODULE.format("lib/${PROJECT_NAME}"),
            MODULES | {"my_pkg/__init__.py": "from . import fast\n"},
        ),
        package(MODULE.format("lib/python3.12/site-packages/my_pkg"), MODULES),
        package(MODULE.format("lib"), MODULES | {"README.md": "Set PYTHONPATH.\n"}),
        package(
            MODULE.format("lib/my_pkg") + "install(PROGRAMS scripts/talk.py DESTINATION lib/my_pkg)\n",
            MODULES | {"scripts/talk.py": NODE + "import fast\n"},
        ),
    ),
    "CMK114": (
        package("find_package(ament_lint_auto REQUIRED)\nament_lint_auto_find_test_files()\n"),
        package("find_package(ament_cmake_python REQUIRED)\nament_install_python_package(my_pkg)\n"),
        package("find_package(ament_cmake_auto REQUIRED)\nament_auto_add_gmock(x)\n"),
        package("function(ament_lint_auto_find_test_files)\nendfunction()\nament_lint_auto_find_test_files()\n"),
    ),
    "CMK117": (
        package(HANDED.format("", "rclcpp tf_ros"), MAIN),
        package(HANDED.format("find_package(Eigen3 REQUIRED)\n", "rclcpp tf_ros"), MAIN),
        package(HANDED.format("find_package(acme REQUIRED)\n", "rclcpp tf_ros"), MAIN),
        package(HANDED.format("set(tf_ros_FOUND 1)\n", "rclcpp tf_ros"), MAIN),
        package(HANDED.format("", "rclcpp soup"), MAIN),
        package("add_library(acme::arm SHARED IMPORTED)\nament_export_dependencies(acme::arm)\n"),
    ),
    "CMK118": (
        package(LIBRARY + "ament_export_libraries(core core_robot other)\n"),
        package("find_package(core_robot REQUIRED)\n" + LIBRARY + "ament_export_libraries(core core_robot)\n"),
    ),
    "CMK103": (
        *(
            package(CORE.format("SHARED ") + PROGRAM + INSTALLED.format("").replace("lib)", f"{place})"))
            for place in ("bin", "lib", "share/my_pkg")
        ),
    ),
    "CMK106": (
        package(LIBRARY + "ament_export_libraries(core)\n"),
        package(LIBRARY + PLUGINS + "ament_export_libraries(core)\n"),
        package(SET + TOLD.format("include/my_pkg") + EXPORT),
        package(SET + TOLD.format("include/my_pkg") + EXPORT, FILES | {"src/core.cpp": "#include <core.hpp>\n"}),
        package(SET + TOLD.format("include") + EXPORT),
        package(SET.replace(HEADERS, "") + TOLD.format("include") + PLUGINS + EXPORT),
        beside_user(LIBRARY + "ament_export_libraries(core)\n"),
        beside_user(CORE.format("") + INSTALLED.format("")),
        beside_user(CORE.format("") + INSTALLED.format(""), "include_directories(../my_pkg/include)\n"),
        package(LIBRARY + EXPORTED, DEEP),
        package(LIBRARY + EXPORTED + "install(FILES src/my_pkg/more.hpp DESTINATION include/my_pkg)\n", DEEP),
        package(LIBRARY + EXPORTED, WITH),
        package(LIBRARY + EXPORTED, WINDOW),
        package(LIBRARY, DEEP),
    ),
    "CMK201": (
        package(CORE.format("") + REACHED.format("PRIVATE include") + PROGRAM, OWN),
        package(CORE.format("") + REACHED.format("PUBLIC include") + PROGRAM, OWN),
        package(CORE.format("") + REACHED.format("include") + PROGRAM, OWN),
    ),
    "CMK108": (
        package(
            "find_package(rclcpp_components REQUIRED)\nadd_library(core SHARED src/core.cpp)\n"
            'rclcpp_components_register_node(talker PLUGIN "my_pkg::Talker" EXECUTABLE talker)\n',
            FILES,
            "  <depend>rclcpp_components</depend>\n",
        ),
    ),
    "CMK110": (
        package(LINKED.format("std_msgs", "std_msgs::std_msgs"), MAIN),
        package(
            LINKED.format("std_msgs", "std_msgs::std_msgs"), MAIN | {"README.md": "Built with Humble and Jazzy.\n"}
        ),
        package(
            LINKED.format("std_msgs", "std_msgs::std_msgs"), MAIN | {"README.md": "Built with Humble, and Rolling.\n"}
        ),
        package(LINKED.format("std_msgs", "std_msgs::std_msgs"), MAIN, "", "humble"),
        package(LINKED.format("std_msgs", "std_msgs::std_msgs"), MAIN, "", "lyrical"),
        package(LINKED.format("std_msgs", "PRIVATE std_msgs"), MAIN),
        package(LINKED.format("std_msgs", "${std_msgs_TARGETS}"), MAIN),
        package(LINKED.format("acme_msgs", "acme_msgs::acme_msgs acme_msgs"), MAIN),
        package(LINKED.format("rclcpp", "PUBLIC rclcpp"), MAIN),
        package("link_directories(/opt/ros/jazzy/lib)\n" + LINKED.format("rclcpp", "rclcpp"), MAIN),
        package(LINKED.format("acme_core", "acme_core"), MAIN),
        package(GENERATES + PROGRAM.replace("talker core", "talker my_pkg"), GENERATED, INTERFACES),
        package(GENERATES + PROGRAM.replace("talker core", "talker my_pkg"), GENERATED, INTERFACES, "humble"),
        package(
            GENERATES + 'rosidl_get_typesupport_target(support pkg "rosidl_typesupport_cpp")\n', GENERATED, INTERFACES
        ),
        package(
            GENERATES + 'rosidl_get_typesupport_target(support my_pkg "rosidl_typesupport_cpp")\n',
            GENERATED,
            INTERFACES,
        ),
        package(
            "find_package(std_msgs REQUIRED)\nadd_library(std_msgs::std_msgs INTERFACE IMPORTED)\n"
            + LINKED.format("std_msgs", "std_msgs::std_msgs"),
            MAIN,
        ),
    ),
    "CMK112": (
        package(CONFIG, CONFIGURED | {"scripts/talk.py": NODE}),
        package(CONFIG + "# scripts are for developers\n", CONFIGURED | {"scripts/talk.py": NODE}),
        package(CONFIG, TOOLED),
        package(CONFIG, TOOLED | {"README.md": "Start make_maps.\n"}),
        package(CONFIG, TOOLED | {"README.md": "`scripts/make_maps.py`\n"}),
    ),
    "CMK115": (
        package(LINKED.format("std_msgs", "${std_msg_TARGETS}"), MAIN),
        package(LINKED.format("std_msgs", "${std_srvs_TARGETS}"), MAIN),
        package(LINKED.format("std_msgs", "${std_msg_FILES}"), MAIN),
    ),
    "CMK119": (
        package(LIBRARY),
        package(LIBRARY, REGISTERED),
        package(LIBRARY, FILES | {"cmake/core-extras.cmake": "set(A b)\n"}),
        package(LIBRARY, FILES | {"src/core.cpp": "int core() {return 1;}\n"}),
        package(LIBRARY.replace("DESTINATION lib)", "DESTINATION lib/my_pkg)")),
        package(LIBRARY + "ament_export_libraries(core)\n"),
        beside_user(LIBRARY),
    ),
    "CMK121": (
        *(
            package(GENERATES + PROGRAM.replace("talker core", links) + more, GENERATED, INTERFACES)
            for links, more in (
                ("talker m", ""),
                ('talker "${support}"', 'rosidl_get_typesupport_target(support my_pkg "rosidl_typesupport_cpp")\n'),
                ("talker ${support}", ""),
                ("talker m", 'rosidl_target_interfaces(talker my_pkg "rosidl_typesupport_cpp")\n'),
                ("talker my_pkg__rosidl_typesupport_cpp", ""),
                ("talker m", "find_package(my_pkg REQUIRED)\n"),
            )
        ),
        package(GENERATES + PROGRAM.replace("talker core", "talker m"), SWITCHED, INTERFACES),
        package(f"find_package(std_msgs REQUIRED)\n{PROGRAM}".replace("talker core", "talker m"), TWINS, MESSAGES),
        package(INDEXED, SHARING, NODES),
        package(INDEXED, SHARING | {"README.md": "For Humble.\n"}, NODES),
        package(INDEXED, SHARING | {"README.md": "For Humble and Jazzy.\n"}, NODES),
    ),
    "CMK126": (
        package(
            "add_subdirectory(core)\nament_export_libraries({NAME})\n",
            {
                "core/CMakeLists.txt": "set(NAME core)\nament_export_libraries({NAME})\nadd_library({NAME} core.cpp)\n",
                "core/core.cpp": "int core() {return 1;}\n",
            },
        ),
    ),
    "CMK123": (
        package("add_compile_options(-Wall WITH_ARM=1 -include MY_FILE -D WITH_LEG /D WITH_TAIL)\n"),
        package("add_definitions(-DWITH_ARM WITH_LEG)\n"),
        package('set(libs "")\nset(libs "${libs} m")\n' + LINKED.format("std_msgs", '"${libs}"'), MAIN),
        package('set(libs "${UNKNOWN} m")\n' + LINKED.format("std_msgs", '${libs} " "'), MAIN),
        package(CORE.format("") + "target_compile_options(core PRIVATE -Wall USE_ARM ${FLAGS})\n"),
        package(PUBLIC.format("PUBLIC include", EXPORT)),
        package(PUBLIC.format("PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/include", EXPORT)),
        package(PUBLIC.format("PRIVATE include", EXPORT)),
        package(PUBLIC.format("PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>", EXPORT)),
        package(PUBLIC.format("PUBLIC include", "")),
    ),
}
