"""Sentences and silences of the rules for CMake: where scripts go, which targets there are, what is registered."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest
from rospkg_cli.rules.cmake import cmk005_removed_command as cmk005
from rospkg_cli.rules.cmake import cmk108_unregistered_component as cmk108

HASH = "#!/usr/bin/env python3\n"
HOME = "DESTINATION lib/${PROJECT_NAME}"
MAIN = "int main() {return 0;}\n"


def package(*lines: str, files: dict[str, str] | None = None, needs: tuple[str, ...] = ()) -> Example:
    """A CMake package with lines before ament_package()."""
    text = CMAKE.replace("ament_package", "".join(f"{line}\n" for line in lines) + "ament_package")
    body = "".join(f"  <depend>{name}</depend>\n" for name in needs)
    given = {"CMakeLists.txt": text, "package.xml": manifest(body, "ament_cmake")}
    return Example(bad={**given, **(files or {})}, good={}, on="ament_cmake")


def scripts(**texts: str) -> dict[str, str]:
    return {f"scripts/{name}".replace("__", "/").replace("_DOT_", "."): text for name, text in texts.items()}


PLAIN = "print()\n"
KINDS = scripts(
    a_DOT_py=HASH + PLAIN,
    b_DOT_sh="#!/bin/sh\n",
    c_DOT_py=PLAIN,
    d="#!/bin/sh\n",
    e_DOT_txt="#!/x\n",
    f_DOT_bash="#!/bin/bash\n",
    g_DOT_yaml="a: 1\n",
    __init___DOT_py="",
    h_DOT_lua="#!/usr/bin/lua\n",
)
LISTED = " ".join(f"scripts/{path.rpartition('/')[2]}" for path in KINDS)
IMPORTED = scripts(
    a_DOT_py=HASH + "import helper\nfrom .other import x\n",
    helper_DOT_py=HASH,
    other_DOT_py=HASH,
    third_DOT_py=HASH,
    fourth_DOT_py=PLAIN,
)
LAUNCHED = {"launch/a.launch.py": "cmd = ['python3', 'x/third.py']\nmore = ['x/fourth.py']\n"}
LEFT = scripts(
    a_DOT_py=HASH + "run('b.py')\n",
    b_DOT_py=HASH,
    c_DOT_py=HASH + "import rclpy\n",
    d_DOT_py=PLAIN,
    _e_DOT_py=HASH,
    test_f_DOT_py=HASH,
    g_DOT_py=HASH,
    h_DOT_txt=HASH,
    i_DOT_sh="#!/bin/sh\nros2 topic list\n",
    j_DOT_py=HASH,
    k_DOT_py=HASH,
    tests__l_DOT_py=HASH,
)
TOLD = {"README.md": "Run g.py.\n", "launch/a.launch.py": "executable='j.py'\n"}
PROGRAM = f"install(PROGRAMS scripts/a.py {HOME})"
NODES = {
    "src/a.cpp": MAIN,
    "scripts/a.py": HASH,
    "scripts/b.py": HASH + "import rclpy\n",
    "scripts/c.py": HASH,
    "README.md": "ros2 run my_pkg readme_tool and ros2 run other_pkg tool\n",
    "launch/a.launch.py": "Node(package='my_pkg', executable='started')\nx = ['/c.py']\n",
    "launch/a.launch.xml": '<node pkg="my_pkg" exec="by_xml"/>\n',
}
ROS = ("find_package(rclcpp REQUIRED)", "find_package(std_msgs REQUIRED)")


def placed(name: str, to: str, *links: str, kind: str = "TARGETS") -> tuple[str, ...]:
    linked = (f"target_link_libraries({name} {' '.join(links)})",) if links else ()
    return (f"add_executable({name} src/a.cpp)", *linked, f"install({kind} {name} {to})")


COMPONENTS = {"src/talker.cpp": cmk108.SOURCE, "src/listener.cpp": cmk108.SOURCE.replace("Talker", "Listener")}
NEEDS = ("rclcpp", "rclcpp_components")
HEAD = ("find_package(rclcpp REQUIRED)", "find_package(rclcpp_components REQUIRED)")
INSTALLED = "install(TARGETS talker LIBRARY DESTINATION lib)"


def components(*lines: str, target: str = "add_library(talker SHARED src/talker.cpp)", **files: str) -> Example:
    named = {f"src/{name}.cpp": text for name, text in files.items()}
    return package(*HEAD, target, INSTALLED, *lines, files={**COMPONENTS, **named}, needs=NEEDS)


def register(target: str, plugin: str, command: str = "rclcpp_components_register_node") -> str:
    return f'{command}({target} PLUGIN "{plugin}" EXECUTABLE {plugin.rpartition(":")[2].lower()}_node)'


LINKED = (
    "(talker rclcpp std_msgs)",
    "(talker PUBLIC rclcpp)",
    "(talker SYSTEM rclcpp)",
    "(talker PUBLIC SYSTEM rclcpp)",
    "(talker INTERFACE rclcpp PRIVATE std_msgs)",
    "(talker rclcpp rclcpp)",
    "(talker ${rclcpp_LIBRARIES} std_msgs)",
    "(talker who_knows)",
    "(talker Eigen3 OpenCV Boost)",
    "(talker ${UNKNOWN} rclcpp)",
    "(talker)",
    "()",
    "(${NAME} rclcpp)",
    "(talker ${found})",
    "(talker tf2_geometry_msgs)",
    "(talker PUBLIC ${found} PRIVATE rclcpp)",
    "(talker eigen3_cmake_module)",
)
TALKER = "add_executable(talker src/talker.cpp)"
TWO = (*ROS, "set(found std_msgs rclcpp)", TALKER)
GTEST = "find_package(ament_cmake_gtest REQUIRED)\nament_add_gtest(talker test/a.cpp)"


def removed(*lines: str) -> Example:
    return package(*lines, files={"src/talker.cpp": MAIN, "test/a.cpp": MAIN}, needs=("rclcpp", "std_msgs"))


LATE = (
    "ament_export_dependencies(rclcpp)",
    "ament_export_targets(a)",
    "install(FILES LICENSE DESTINATION share/my_pkg)",
    "pluginlib_export_plugin_description_file(a b.xml)",
    "rclcpp_components_register_node(a PLUGIN b EXECUTABLE c)",
    "rosidl_generate_interfaces(a msg/A.msg)",
    "ament_lint_auto_find_test_dependencies()",
    "ament_auto_add_library(b x.cpp)",
    "ament_add_gtest(t test/a.cpp)",
    "message(STATUS x)",
    "ament_python_install_package(my_pkg)",
    "ament_environment_hooks(a)",
    "ament_copyright()",
    "ament_cppcheck()",
    "ament_package()",
    "if(UNKNOWN)\n  ament_export_libraries(x)\nendif()",
)
EXPORTS = "install(TARGETS core EXPORT core_targets LIBRARY DESTINATION lib)\nament_export_targets(core_targets)"
PYTHON = {
    "my_pkg/__init__.py": "",
    "my_pkg/words.py": "A = 1\n",
    "more/__init__.py": "",
    "more/a.py": "",
    "deep/inner/__init__.py": "",
    "scripts/a.py": HASH + "import os\nimport my_pkg.words\n"
    "from more import a\nfrom more import nothing\nimport deep.inner\n",
    "scripts/b.py": HASH + "try:\n    import my_pkg.words\nexcept ImportError:\n    pass\n",
    "scripts/c.py": HASH + "import sys\nsys.path.insert(0, '.')\nimport my_pkg.words\n",
    "scripts/d.py": HASH + "from my_pkg import something\nimport my_pkg\n",
    "scripts/e.py": HASH + "from .words import A\n",
}
MODULES = "  <buildtool_depend>ament_cmake_python</buildtool_depend>\n"


def python(*lines: str) -> Example:
    return package(*lines, files=PYTHON)


CASES = {
    "CMK004": (
        *(Example(bad={"CMakeLists.txt": f"{CMAKE}{line}\n"}, good={}, on="ament_cmake") for line in LATE),
        Example(bad={"CMakeLists.txt": CMAKE.replace("ament_package", "ament_auto_package") + "\n".join(LATE) + "\n"},
                good={}, on="ament_cmake"),
        Example(bad={"CMakeLists.txt":
                     CMAKE.replace("ament_package", "ament_auto_package") + "\n".join(LATE[:-2]) + "\n"},
                good={}, on="ament_cmake"),
        Example(bad={"CMakeLists.txt": f"{CMAKE}message(x)\nament_export_libraries(x) # here\nmessage(y)\n"}, good={},
                on="ament_cmake"),
    ),
    "CMK005": (
        *(removed(*TWO, f"ament_target_dependencies{each}") for each in LINKED),
        *(removed(*TWO, f"target_link_libraries(talker{each})", "ament_target_dependencies(talker rclcpp)")
          for each in (" m", " PUBLIC m", " LINK_PRIVATE m", " debug m", "")),
        removed(*ROS, GTEST, "ament_target_dependencies(talker rclcpp)"),
        removed(*TWO, "if(COMMAND ament_target_dependencies)\n  ament_target_dependencies(talker rclcpp)\nendif()",
                "if(FALSE)\n  ament_target_dependencies(talker rclcpp)\nendif()"),
        removed(*TWO, "foreach(each rclcpp std_msgs)\n  ament_target_dependencies(talker ${each})\nendforeach()"),
        Example(bad={**cmk005.FILES, "CMakeLists.txt": cmk005.ONE.replace("«", "").replace("»", "")
                     + "ament_target_dependencies(talker rclcpp)\n"}, good={}, on="ament_cmake"),
    ),
    "CMK104": (
        package(*ROS, *placed("bare", "DESTINATION bin"), *placed("node", "DESTINATION bin", "rclcpp::rclcpp"),
                *placed("old", "DESTINATION bin", "${rclcpp_LIBRARIES}"), *placed("msgs", "DESTINATION bin",
                        "${std_msgs_TARGETS}"),
                *placed("math", "DESTINATION bin", "m"), *placed("started", "DESTINATION bin"), *placed("by_xml",
                        "DESTINATION bin"),
                *placed("readme_tool", "DESTINATION bin"), *placed("tool", "DESTINATION bin"), *placed("lib",
                        "DESTINATION lib"),
                *placed("right", HOME), *placed("below", f"{HOME}/more"), *placed("absolute", "DESTINATION /opt/x"),
                *placed("unknown", "DESTINATION ${WHERE}"), *placed("other", "DESTINATION lib/my_pkg_other"),
                *placed("both", "DESTINATION bin"), f"install(TARGETS both {HOME})", files=NODES, needs=("rclcpp",
                        "std_msgs")),
        package("add_library(core SHARED src/a.cpp)", "target_link_libraries(core rclcpp::rclcpp)",
                *placed("through", "DESTINATION bin", "core"), *placed("renamed", "DESTINATION bin"),
                "set_target_properties(renamed PROPERTIES OUTPUT_NAME started)",
                "install(TARGETS core DESTINATION lib)",
                "if(UNKNOWN)\n  install(TARGETS through DESTINATION share)\nendif()", files=NODES),
        package("install(PROGRAMS scripts/a.py scripts/b.py scripts/c.py DESTINATION bin)",
                "install(PROGRAMS scripts/a.py scripts/b.py DESTINATION share/my_pkg)",
                "install(PROGRAMS scripts/a.py DESTINATION lib RENAME started)", files=NODES),
        package("if(BUILD_TESTING)", *placed("tested", "DESTINATION bin"), *placed("shared", "DESTINATION share"),
                "endif()",
                files=NODES),
    ),
    "CMK105": (
        *(package(f"install({kind} {LISTED} {HOME})", files=KINDS) for kind in ("FILES", "PROGRAMS")),
        *(package(f"install(DIRECTORY scripts/ {HOME}{more})", files=KINDS)
          for more in ("", " USE_SOURCE_PERMISSIONS", " FILES_MATCHING PATTERN \"*.sh\"",
                       " FILE_PERMISSIONS OWNER_READ OWNER_EXECUTE", " FILE_PERMISSIONS OWNER_READ")),
        package(f"install(FILES scripts/a.py PERMISSIONS OWNER_READ OWNER_EXECUTE {HOME})",
                f"install(FILES scripts/b.sh PERMISSIONS OWNER_READ {HOME})", files=KINDS),
        package(f"install(PROGRAMS scripts/a.py {HOME})", f"install(FILES scripts/a.py scripts/b.sh {HOME})",
                f"install(DIRECTORY scripts/ {HOME})", files=KINDS),
        package(f"install(FILES scripts/a.py scripts/helper.py scripts/other.py scripts/third.py scripts/fourth.py"
                f" {HOME})",
                files={**IMPORTED, **LAUNCHED}),
        package(f"if(UNKNOWN)\n  install(FILES scripts/a.py {HOME})\nendif()\n"
                f"if(BUILD_TESTING)\n  install(FILES scripts/b.sh {HOME})"
                "\nendif()", "install(FILES scripts/d DESTINATION share/my_pkg)",
                f"install(FILES scripts/f.bash {HOME} RENAME x)",
                files=KINDS),
    ),
    "CMK108": (
        components(register("talker", "my_pkg::Talker")),
        components(register("talker", "my_pkg::Talkr")),
        components("add_executable(main src/main.cpp)", "target_link_libraries(main talker)", main="int main() {}\n"),
        components(register("talker", "other::Thing")),
        components(register("talker", "other::Thing"),
                   target="add_library(talker SHARED src/talker.cpp src/listener.cpp)"),
        components(register("talkre", "my_pkg::Talker")),
        components(register("${TARGET}", "my_pkg::Talker")),
        components(register("talker", "my_pkg::${NAME}")),
        components(register("talker", "my_pkg::Talker", "rclcpp_components_register_nodes")),
        components('rclcpp_components_register_nodes(talker "my_pkg::Talker" "my_pkg::Nothing" "my_pkg::Nothing")'),
        components(f"if(UNKNOWN)\n  {register('talker', 'my_pkg::Nothing')}\nendif()"),
        components(register("talker", "my_pkg::Nothing"), "include(unknown.cmake)"),
        components(register("talker", "my_pkg::Talker"), listener="int none() {return 0;}\n",
                   target="add_library(talker SHARED src/talker.cpp src/gone.cpp)"),
        components(register("talker", "my_pkg::Nothing"),
                   target="add_library(talker SHARED src/talker.cpp src/gone.cpp)"),
        components(register("talker", "my_pkg::Nothing"),
                   target="add_library(talker SHARED src/talker.cpp ${CMAKE_CURRENT_BINARY_DIR}/made.cpp)"),
        components(register("talker", "my_pkg::Nothing"), target="add_library(talker SHARED ${SOURCES})"),
        components(register("talker", "my_pkg::Nothing"),
                   talker="#define REGISTER(x) RCLCPP_COMPONENTS_REGISTER_NODE(x)\nREGISTER(my_pkg::Nothing)\n"),
        components(register("talker", "my_pkg::Nothing"),
                   talker="CLASS_LOADER_REGISTER_CLASS(my_pkg::Nothing, rclcpp::Node)\n"),
        components(register("talker", "my_pkg::Nothing"), talker="int none() {return 0;}\n", listener=""),
        components(register("talker", "my_pkg::Talker"),
                   target="add_library(talker SHARED src/talker.cpp src/listener.cpp)"),
        components(register("talker", "my_pkg::Listner"),
                   target="add_library(talker SHARED src/talker.cpp src/listener.cpp)"),
    ),
    "CMK109": (
        *(python(f"install(PROGRAMS scripts/{each}.py {HOME})") for each in "abcde"),
        python(f"install(PROGRAMS scripts/a.py {HOME})", f"install(DIRECTORY my_pkg {HOME})"),
        python(f"install(PROGRAMS scripts/a.py {HOME})", "find_package(ament_cmake_python REQUIRED)",
               "ament_python_install_package(my_pkg)"),
        python(f"install(PROGRAMS scripts/a.py {HOME})", "ament_environment_hooks(env/path.dsv.in)"),
        python(f"install(PROGRAMS scripts/a.py {HOME})", "install(DIRECTORY my_pkg DESTINATION ${WHERE})"),
        python("install(FILES scripts/a.py DESTINATION share/my_pkg)"),
    ),
    "CMK112": (
        package(PROGRAM, files={**LEFT, **TOLD}),
        package(PROGRAM, "install(PROGRAMS scripts/b.py DESTINATION share/my_pkg)",
                "add_custom_target(x scripts/c.py)",
                files={**LEFT, **TOLD}),
        package(PROGRAM, "install(CODE \"message(x)\")", files=LEFT),
        package(PROGRAM, "install(FILES LICENSE DESTINATION ${WHERE})", files=LEFT),
        package(f"install(FILES scripts/a.py {HOME})", files=LEFT),
        package("install(PROGRAMS scripts/a.py DESTINATION bin)", files=LEFT),
    ),
}  # fmt: skip
