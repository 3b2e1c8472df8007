"""Faults that people repaired in their repositories, told again in small: levels, sentences and silences."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, INTERFACES_BODY, INTERFACES_CMAKE, Example, manifest

CORE = {"src/core.cpp": "int core() {return 1;}\n", "src/talker.cpp": "int main() {return 0;}\n"}
LINKED = """\
add_library(core {}src/core.cpp)
add_executable(talker src/talker.cpp)
target_link_libraries(talker PRIVATE core)
install(TARGETS talker DESTINATION lib/${{PROJECT_NAME}})
install(TARGETS core DESTINATION {})
{}"""
SCRIPTS = {"scripts/tools/plot": "#!/usr/bin/env python3\n", "modes.yaml": "a: 1\n"}
SWITCH = "set(with_camera {})\nif({})\nendif()\n"
SCRIPT = "add_custom_command(OUTPUT sdk.so COMMAND {}get.py)\n"
GET = {"get.py": "pass\n"}


def package(lines: str, files: dict[str, str] | None = None) -> Example:
    """A CMake package with lines before ament_package()."""
    text = CMAKE.replace("ament_package", lines + "ament_package")
    files = {"CMakeLists.txt": text, **(CORE if files is None else files)}
    return Example(bad=files, good={}, on="ament_cmake")


def linked(place: str, more: str = "", kind: str = "SHARED ") -> Example:
    return package(LINKED.format(kind, place, more))


def headers(more: str) -> Example:
    return package(f"install(DIRECTORY include DESTINATION include)\n{more}", {"include/my_pkg/core.hpp": "int i();\n"})


def scripts(lines: str) -> Example:
    return package(lines, SCRIPTS)


def messages(files: dict[str, str], listed: str = "") -> Example:
    text = INTERFACES_CMAKE.replace('  "msg/Status.msg"\n', f'{listed}  "msg/Status.msg"\n')
    return Example(bad={"CMakeLists.txt": text, **files}, good={}, on="interfaces")


def depending(names: str, more: str = "", depends: str = "  <depend>std_msgs</depend>\n") -> Example:
    """Interfaces that depend on packages, and the lines before them."""
    text = INTERFACES_CMAKE.replace('  "srv/SetMode.srv"\n', f'  "srv/SetMode.srv"\n  DEPENDENCIES {names}\n')
    text = text.replace("rosidl_generate", f"{more}rosidl_generate", 1)
    body = manifest(depends + INTERFACES_BODY, "ament_cmake")
    return Example(bad={"CMakeLists.txt": text, "package.xml": body}, good={}, on="interfaces")


def finds(name: str, use: str = "", files: dict[str, str] | None = None) -> Example:
    return package(f"find_package({name} REQUIRED)\n{use}", files or {})


HANDED = """\
add_library(core SHARED src/core.cpp)
ament_target_dependencies(core {0})
install(TARGETS core DESTINATION lib)
"""

TARGETS = """\
find_package(rclcpp REQUIRED)
set(needs {0})
add_library(core SHARED src/core.cpp)
{1}
install(TARGETS core EXPORT core_targets DESTINATION lib)
ament_export_targets(core_targets NAMESPACE my_pkg::)
ament_export_dependencies({2})
"""
LINKS = "target_link_libraries(core PUBLIC ${needs})"
HANDS = "ament_target_dependencies(core PUBLIC {})"


def targets(needs: str, use: str, exported: str) -> Example:
    return package(TARGETS.format(needs, use, exported))


NODE = """\
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
RCLCPP_COMPONENTS_REGISTER_NODE(my_pkg::Talker)
"""
REGISTERS = """\
find_package(rclcpp REQUIRED)
find_package(rclcpp_components REQUIRED)
{}
target_link_libraries(talker rclcpp::rclcpp rclcpp_components::component)
install(TARGETS talker DESTINATION lib)
rclcpp_components_register_node{}
"""
ONE = '(talker PLUGIN "my_pkg::Talker" EXECUTABLE talker_node)'


def components(target: str, call: str = ONE) -> Example:
    return package(REGISTERS.format(target.format("src/talker.cpp"), call), {"src/talker.cpp": NODE})


WORDS = {
    "include/my_pkg/words.hpp": "inline int words() {return 0;}\n",
    "src/talker.cpp": '#include "my_pkg/words.hpp"\n',
    "src/core.cpp": "int core() {return 1;}\n",
}


def told(*lines: str) -> Example:
    """A program that includes a header of the package, and a library that does not."""
    both = ("add_library(core src/core.cpp)", "add_executable(talker src/talker.cpp)", *lines)
    return package("".join(f"{line}\n" for line in both), WORDS)


def crate(table: str, depends: str = "", files: dict[str, str] | None = None) -> Example:
    """A package of Rust that depends on crates."""
    cargo = f'[package]\nname = "my_pkg"\n\n{table}\n'
    body = {"package.xml": manifest(depends, "ament_cargo"), "Cargo.toml": cargo, "src/main.rs": "fn main() {}\n"}
    return Example(bad={**body, **(files or {})}, good={}, on="")


CRATE = "[dependencies]\nstd_msgs = {}"
POINTED = '[patch.crates-io]\nstd_msgs = { path = "../std_msgs" }\n'

CASES = {
    "DEP121": (
        *(
            crate(CRATE.format(value))
            for value in (
                '{ version = "*" }',
                '{ path = "../std_msgs" }',
                '{ git = "https://example.org/std_msgs" }',
                '{ version = "*", optional = true }',
                '"5.3"',
                '"*"  # any',
                "{ workspace = true }",
            )
        ),
        crate('[dependencies.std_msgs]\nversion = "*"'),
        crate('[dependencies.std_msgs]\nversion = "*"\noptional = true\n\n[features]\na = []'),
        crate('[build-dependencies]\nstd_msgs = "*"'),
        crate('[dependencies]\nstd_msgs.version = "*"\nserde = "*"\nmy_own_msgs = "*"\n# sensor_msgs = "*"'),
        crate(CRATE.format('"*"') + "\n\n" + POINTED),
        crate(CRATE.format('"*"'), files={".cargo/config.toml": POINTED}),
        crate(CRATE.format('"*"'), "  <depend>geometry_msgs</depend>\n"),
        crate(CRATE.format('"*"'), "  <!-- <depend>std_msgs</depend> -->\n"),
        crate(CRATE.format('"*"'), "  <depend>acme_tools</depend>\n"),
    ),
    "CMK201": (
        told("include_directories(${CMAKE_CURRENT_BINARY_DIR})"),
        told("include_directories(include)"),
        told("include_directories(${WHERE})"),
        told("find_package(rclcpp REQUIRED)", "include_directories(${rclcpp_INCLUDE_DIRS})"),
        told("target_include_directories(core PUBLIC include)"),
        told("target_include_directories(core PUBLIC include)", "target_link_libraries(talker core)"),
        told("target_include_directories(core PUBLIC include)", "target_link_libraries(talker ${WHAT})"),
        told("target_include_directories(talker PRIVATE $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>)"),
        told("target_include_directories(talker PRIVATE $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/src>)"),
        told("target_include_directories(talker PUBLIC $<INSTALL_INTERFACE:include>)"),
        told("target_include_directories(${EVERY} PRIVATE include)"),
        told("target_include_directories(core PUBLIC include)", "target_compile_options(talker PRIVATE -Iinclude)"),
        told("target_include_directories(core PUBLIC include)", "add_executable(other src/talker.cpp)"),
    ),
    "CMK108": (
        components("add_executable(talker {})"),
        components("add_executable(talker {})", 's(talker "my_pkg::Talker")'),
        components("add_library(talker STATIC {})"),
        components("add_library(talker OBJECT {})"),
        components("add_library(talker {})"),
        components("add_library(talker MODULE {})"),
        components("add_executable(talker {})", ONE.replace("Talker", "Speaker")),
        components("if(WITH)\n  add_executable(talker {0})\nelse()\n  add_library(talker SHARED {0})\nendif()"),
        components("if(WITH)\n  add_executable(talker {})\nendif()"),
    ),
    "CMK117": (
        targets("rclcpp::rclcpp std_msgs::std_msgs", LINKS, "${needs}"),
        targets("rclcpp::rclcpp", LINKS, "rclcpp::rclcpp"),
        targets("rclcpp::rclcpp", LINKS, "my_pkg::core"),
        targets("rclcpp::rclcpp", LINKS, "${std_msgs_TARGETS}"),
        targets("rclcpp", HANDS.format("rclcpp::rclcpp"), "rclcpp"),
        targets("rclcpp", HANDS.format("${needs}"), "rclcpp"),
        targets("rclcpp", "if(WITH)\n" + HANDS.format("rclcpp::rclcpp") + "\nendif()", "rclcpp"),
    ),
    "DEP104": (
        *(
            Example(
                bad={
                    **finds("rclcpp_action").bad,
                    "package.xml": manifest(f"  <depend{when}>actionlib</depend>\n", "ament_cmake"),
                },
                good={},
                on="ament_cmake",
            )
            for when in (' condition="$ROS_VERSION == 1"', "")
        ),
        finds("acme_tools", HANDED.format("acme_tools"), CORE),
        finds("acme", HANDED.format("acme"), CORE),
        finds("AcmeTools", HANDED.format("AcmeTools"), CORE),
        finds("acme_tools", HANDED.format("acme_tools"), {**CORE, "cmake/Findacme_tools.cmake": ""}),
        finds("tf_ros", HANDED.format("tf_ros"), {"src/core.cpp": "#include <tf2_ros/buffer.h>\n"}),
        finds("GDAL"),
        finds("GDAL", "add_library(GDAL SHARED IMPORTED)\n"),
        finds("GDAL", "", {"cmake/FindGDAL.cmake": ""}),
        finds("GDAL", 'fetchcontent_declare(gdal GIT_REPOSITORY "https://example.org/gdal")\n'),
        package("find_package(GDAL)\n", {}),
        finds("Sophus"),
        finds("Unheard"),
        finds("Qt5Quick"),
    ),
    "DEP105": (
        package(HANDED.format("rclcpp"), {"src/core.cpp": "#include <acme_tools/srv/set_mode.hpp>\n"}),
        package(HANDED.format("rclcpp"), {"src/core.cpp": "#include <acme_tools/srv_mode.hpp>\n"}),
    ),
    "DEP107": (
        depending("std_msgs"),
        depending("std_msgs", "find_package(std_msgs REQUIRED)\n"),
        depending("std_msgs", "find_package(geometry_msgs REQUIRED)\n"),
        depending("std_msgs", "find_package(acme_msgs REQUIRED)\n"),
        depending("std_msgs", depends=""),
        depending("builtin_interfaces", depends="  <depend>builtin_interfaces</depend>\n"),
        depending("acme_msgs", depends=""),
    ),
    "DEP115": (package("pkg_check_modules(ODE REQUIRED ode)\n", {}),),
    "CMK103": (
        linked("lib/${PROJECT_NAME}"),
        linked("share/my_pkg/"),
        linked("lib/python3.12/site-packages"),
        linked("lib64"),
        linked("lib/my_pkg", "install(TARGETS core DESTINATION lib)\n"),
        linked("lib/my_pkg", "if(UNKNOWN)\n  install(TARGETS core DESTINATION lib)\nendif()\n"),
        linked("lib/my_pkg", 'set_target_properties(talker PROPERTIES INSTALL_RPATH "$ORIGIN")\n'),
        linked("lib/my_pkg", "include(${elsewhere}/more.cmake)\n"),
        linked("lib/my_pkg", kind=""),
        package("add_library(core SHARED src/core.cpp)\ninstall(TARGETS core DESTINATION lib/my_pkg)\n"),
    ),
    "CMK104": (
        scripts("install(DIRECTORY scripts/tools DESTINATION lib)\n"),
        scripts("install(DIRECTORY scripts/ DESTINATION lib/my_pkg)\n"),
        scripts("install(FILES modes.yaml DESTINATION share)\n"),
        scripts("install(FILES modes.yaml DESTINATION share/)\ninstall(FILES modes.yaml DESTINATION share/my_pkg)\n"),
        scripts("install(FILES modes.yaml DESTINATION lib)\n"),
        scripts("if(UNKNOWN)\n  install(FILES modes.yaml DESTINATION share)\nendif()\n"),
        package("install(DIRECTORY man DESTINATION share)\n", {"man/man1/talker.1": "talker\n"}),
        package(
            "install(DIRECTORY config DESTINATION share)\n", {"config/a.yaml": "a: 1\n", "config/b.yaml": "a: 1\n"}
        ),
        package("install(DIRECTORY tools DESTINATION lib)\n", {"tools/plot.py": "x = 1\n"}),
    ),
    "CMK128": (
        package(
            "find_package(pcl_ros REQUIRED)\nfind_package(Boost REQUIRED)\nadd_executable(talker src/talker.cpp)\n"
            "target_link_libraries(talker Boost::thread)\ninstall(TARGETS talker DESTINATION lib/my_pkg)\n"
        ),
    ),
    "CMK129": (
        package(
            "install(DIRECTORY include/ DESTINATION include)\n"
            'install(DIRECTORY include/ DESTINATION include FILES_MATCHING PATTERN "*.h")\n',
            {"include/my_pkg/core.hpp": "int i();\n"},
        ),
    ),
    "CMK106": (headers(""), headers("add_library(core INTERFACE)\nament_export_libraries(core)\n")),
    "CMK123": (
        package(SWITCH.format("flase", "NOT with_camera")),
        package(SWITCH.format("flase", "${with_camera}")),
        package(SWITCH.format("floor", "with_camera")),
        package(SWITCH.format("Flase", "A AND with_camera")),
        package(SWITCH.format("flase other", "with_camera")),
        package(SWITCH.format("flase CACHE BOOL camera", "with_camera")),
        package('option(with_camera "camera" fasle)\nif(with_camera)\nendif()\n'),
        package(SCRIPT.format("${CMAKE_CURRENT_SOURCE_DIR}"), GET),
        package(SCRIPT.format("${PROJECT_SOURCE_DIR}/"), GET),
        package(SCRIPT.format("${CMAKE_CURRENT_LIST_DIR}"), GET),
        package(SCRIPT.format("${CMAKE_CURRENT_SOURCE_DIR}"), {}),
        package("add_subdirectory(sdk)\n", {"sdk/CMakeLists.txt": SCRIPT.format("${CMAKE_CURRENT_SOURCE_DIR}"), **GET}),
        package(
            "add_subdirectory(sdk)\n",
            {"sdk/CMakeLists.txt": SCRIPT.format("${CMAKE_CURRENT_SOURCE_DIR}"), "sdk/get.py": ""},
        ),
        package(
            "add_subdirectory(sdk)\n",
            {"sdk/CMakeLists.txt": SCRIPT.format("${CMAKE_CURRENT_SOURCE_DIR}"), "sdk/get.py": "", "sdkget.py": ""},
        ),
        package(
            "add_subdirectory(sdk)\n",
            {"sdk/CMakeLists.txt": SCRIPT.format("${CMAKE_CURRENT_LIST_DIR}"), "sdk/get.py": ""},
        ),
        package("add_library(core SHARED ${CMAKE_CURRENT_SOURCE_DIR}src/core.cpp)\n"),
    ),
    "IDL005": (
        messages({"msg/Speed.msg": "Float32 speed\n"}),
        messages({"msg/Speed.msg": "stds_msgs/Float32 speed\n"}),
        messages({"msg/Speed.msg": "acme_msgs/Float32 speed\n"}),
        messages({"msg/Speed.msg": "int speed\n"}),
        messages({"msg/speed.msg": "float32 speed\n"}),
    ),
    "IDL014": (
        messages({"msg/Status.msg": "my_pkg/Status[] parts\n"}),
        messages({"msg/Status.msg": "other_msgs/Status[] parts\n"}),
        messages({"msg/Status.msg": "Part[] parts\n", "msg/Part.msg": "Status whole\n"}),
        messages({"msg/Status.msg": "Part[] parts\n", "msg/Part.msg": "Part part\nStatus a\n"}, '  "msg/Part.msg"\n'),
        Example(
            bad={
                "CMakeLists.txt": INTERFACES_CMAKE.replace('"msg/Status.msg"', "${files}"),
                "msg/Status.msg": "Status a\n",
            },
            good={},
            on="interfaces",
        ),
        messages({"srv/Status.srv": "Status a\n---\nStatus b\n"}, '  "srv/Status.srv"\n'),
    ),
}
