"""What a build never reaches, or reaches in another way: headers that move, libraries that no linker sees."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest, setup_py

MAIN = "int main() {return 0;}\n"
PROGRAM = "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
OLD = "#include <ros/ros.h>\n"
SOME = "#include <my_pkg/wrds.hpp>\n"
HEADERS = {"include/my_pkg/words.hpp": "int words();\n"}
REACHED = "include_directories(include)\n"
CORE = {"src/core.cpp": "int core() {return 1;}\n"}
LINKED = "add_library(core {}src/core.cpp)\ntarget_link_libraries(core SHARED m)\n"


def package(lines: str, files: dict[str, str], body: str = "") -> Example:
    text = CMAKE.replace("ament_package", lines + "ament_package")
    files = {"package.xml": manifest(body, "ament_cmake"), **files}
    return Example(bad={"CMakeLists.txt": text, **files}, good={}, on="ament_cmake")


def opened(header: str, *, guarded: bool) -> Example:
    """Return a program that includes a header, which includes another one."""
    include = '#include "old.hpp"\n'
    files = {
        "src/talker.cpp": '#include "all.hpp"\n' + MAIN,
        "src/all.hpp": f"#ifdef WITH_OLD\n{include}#endif\n" if guarded else include,
        "src/old.hpp": '#include "older.hpp"\n',
        "src/older.hpp": header,
    }
    return package(REACHED + PROGRAM, files | HEADERS)


def used(lines: str) -> Example:
    """Return a package that includes a header of another one, which installs it into a folder of its own name."""
    core = CMAKE.replace("(my_pkg)", "(core)").replace("ament_package", lines + "ament_package")
    user = CMAKE.replace("ament_package", "find_package(core REQUIRED)\n" + PROGRAM + "ament_package")
    files = {
        "core/package.xml": manifest("", "ament_cmake").replace("<name>my_pkg", "<name>core"),
        "core/CMakeLists.txt": core,
        "core/include/common/words.hpp": "int words();\n",
        "core/include/core/core.hpp": "int core();\n",
        "my_pkg/package.xml": manifest("  <depend>core</depend>\n", "ament_cmake"),
        "my_pkg/CMakeLists.txt": user,
        "my_pkg/src/talker.cpp": "#include <core/common/words.hpp>\n" + MAIN,
    }
    return Example(bad=files, good={}, on="")


TO = "install(DIRECTORY include/ DESTINATION include{})\nament_export_include_directories({})\n"
BESIDE = """\
add_library(core SHARED src/core.cpp)
add_library(plugin {} src/plugin.cpp)
target_link_libraries(plugin core)
install(TARGETS core DESTINATION lib/my_pkg)
install(TARGETS plugin DESTINATION {})
"""
DYNAMIC = """\
add_library(core SHARED src/core.cpp)
add_executable(talker src/talker.cpp)
target_link_libraries(talker core)
install(TARGETS core talker DESTINATION lib/my_pkg)
"""
USE = '#include "core.hpp"\n'
USED = {"src/core.cpp": USE, "src/core.hpp": "int core();\n", "src/plugin.cpp": USE}
BUILT = "add_executable(talker src/talker.cpp)\n"
NODE = "#include <rclcpp/rclcpp.hpp>\nint main() {rclcpp::init(0, nullptr);}\n"
STARTS = ("./talker", "build/my_pkg/talker", "ros2 run my_pkg talker", "talker", "./talker.sh")
HPP = {"include/my_pkg/core.h": "int core();\n"}
MATCHING = 'install(DIRECTORY include/ DESTINATION {} FILES_MATCHING PATTERN "{}")\n'
ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
GLOB = "        ('share/' + package_name + '/config', glob('config/*.yaml')),\n"
SETUP = "from glob import glob\n" + setup_py().replace(ENTRY, ENTRY + GLOB)
CONFIG = {"setup.py": SETUP, "config/a.yaml": "a: 1\n", "config/b.yml": "b: 1\n"}


def configured(**files: str) -> Example:
    """Return a Python package that installs a folder without one of its files."""
    more = {path.replace("__", "/").replace("_DOT_", "."): text for path, text in files.items()}
    return Example(bad=CONFIG | more, good={})


INNER = manifest().replace("<name>my_pkg</name>", "<name>my_driver</name>")
INCLUDED = "find_package(std_msgs REQUIRED)\ninclude_directories(${STD_MSGS_INCLUDE_DIRS})\n"
FLAT = "install(PROGRAMS {} DESTINATION lib/${{PROJECT_NAME}})\n"
PYTHON = {
    "src/talk.py": "#!/usr/bin/env python3\nfrom words.hello import HELLO\n\nprint(HELLO)\n",
    "src/words/__init__.py": "",
    "src/words/hello.py": "HELLO = 'hello'\n",
}
CASES = {
    "CMK103": (
        package(BESIDE.format("SHARED", "lib"), USED),
        package(BESIDE.format("SHARED", "lib/my_pkg"), USED),
        package(BESIDE.format("MODULE", "lib"), USED),
        package(DYNAMIC, USED | {"src/talker.cpp": f"#ifndef PLUGIN\n{USE}#endif\n{MAIN}"}),
        *(package(BUILT, {"src/talker.cpp": NODE, "README.md": f"Start `{line}`.\n"}) for line in STARTS),
        package(DYNAMIC, USED | {"src/core.cpp": "int core() {return 1;}\n", "src/talker.cpp": USE + MAIN}),
    ),
    "CMK201": (
        used(TO.format("", "include")),
        used(TO.format("/${PROJECT_NAME}", "include")),
        used(TO.format("/deep/core", "include/deep")),
        opened(OLD, guarded=True),
        opened(OLD, guarded=False),
        opened(SOME, guarded=True),
        opened(SOME, guarded=False),
    ),
    "IDL012": (
        opened("#include <std_msgs/msg/strin.hpp>\n", guarded=True),
        opened("#include <std_msgs/msg/strin.hpp>\n", guarded=False),
    ),
    "CMK116": (
        package(
            'function(add_ros_isolated_launch_test path)\n  add_launch_test("${path}" ${ARGN})\nendfunction()\n', {}
        ),
    ),
    "SET207": (
        configured(),
        configured(config__a_DOT_yaml="file: b.yml\n"),
        configured(config__a_DOT_yaml="file: /ws/src/my_pkg/config/b.yml\n"),
        configured(config__a_DOT_yaml="file: b.yml\n", config__b_DOT_yml=""),
    ),
    "WSP005": tuple(
        Example(bad={"control/driver/package.xml": INNER, "README.md": text}, good={})
        for text in (
            "colcon build\n",
            "cd ~/robot/control\ncolcon build\n",
            "cd ~/robot\ncolcon build\ncd control\n",
            "colcon build --base-paths control\n",
        )
    ),
    "CMK115": tuple(
        package(INCLUDED + PROGRAM + line, {"src/talker.cpp": MAIN})
        for line in (
            "",
            "ament_target_dependencies(talker std_msgs)\n",
            "target_link_libraries(talker std_msgs::std_msgs)\n",
            "target_include_directories(talker PRIVATE ${std_msgs_INCLUDE_DIRS})\n",
            "ament_target_dependencies(talker std_srvs)\n",
        )
    ),
    "CMK109": (
        package('file(GLOB_RECURSE all "src/*.py")\n' + FLAT.format("${all}"), PYTHON),
        package(FLAT.format("src/talk.py"), PYTHON),
    ),
    "CMK129": (
        package(MATCHING.format("include", "*.hpp"), HPP),
        package(f"function(give)\n{MATCHING.format('include', '*.hpp')}endfunction()\ngive()\n", HPP),
        package(MATCHING.format("include", "*.hpp") + MATCHING.format("include", "*.h"), HPP),
        package(MATCHING.format("include", "*.hpp") + MATCHING.format("include/${WHERE}", "*.h"), HPP),
    ),
    "CMK123": (
        package(LINKED.format(""), CORE),
        package(LINKED.format("STATIC "), CORE),
        package("set(BUILD_SHARED_LIBS ON)\n" + LINKED.format(""), CORE),
        package("find_package(ament_cmake_ros REQUIRED)\n" + LINKED.format(""), CORE),
        package(LINKED.format("") + PROGRAM + "target_link_libraries(talker core)\n", CORE | {"src/talker.cpp": MAIN}),
        package(PROGRAM + "target_link_libraries(talker SHARED m)\n", {"src/talker.cpp": MAIN}),
    ),
}
