"""What a package does not export, and that nobody can use anyway, against what others use (CMK113, CMK119)."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

NAMES = ("rclcpp", "std_msgs")
NEEDS = "".join(f"  <depend>{name}</depend>\n" for name in NAMES)
HEADER = "#include <rclcpp/rclcpp.hpp>\n#include <std_msgs/msg/string.hpp>\n"
FILES = {"src/core.cpp": '#include "my_pkg/core.hpp"\n', "include/my_pkg/core.hpp": HEADER}
LIBRARY = """\
find_package(rclcpp REQUIRED)
find_package(std_msgs REQUIRED)
add_library(core SHARED src/core.cpp)
ament_target_dependencies(core rclcpp std_msgs)
install(DIRECTORY include/ DESTINATION include)
install(TARGETS core DESTINATION lib)
ament_export_libraries(core)
"""
TELLS = "ament_export_include_directories(include)\n"
EXTRAS = 'ament_package(CONFIG_EXTRAS "core-extras.cmake")\n'
USER = manifest("  <depend>my_pkg</depend>\n", "ament_cmake").replace("<name>my_pkg", "<name>user")
USES = CMAKE.replace("my_pkg", "user").replace(
    "ament_package", "find_package(my_pkg REQUIRED)\nadd_executable(user a.cpp)\nament_package"
)
USERS = {"user/package.xml": USER, "user/CMakeLists.txt": USES, "user/a.cpp": "#include <my_pkg/core.hpp>\n"}

SET = """\
add_library(core SHARED src/core.cpp)
install(TARGETS core EXPORT core_targets DESTINATION lib)
"""
HEADERS = "install(DIRECTORY include/ DESTINATION include)\n"
BASE = "add_library(base {})\ninstall(TARGETS base EXPORT core_targets DESTINATION lib)\n"
NODES = FILES | {"src/core.cpp": "BT_REGISTER_NODES(factory) {}\n"}
DESCRIBED = FILES | {
    "plugins.xml": '<library path="core"><class type="my_pkg::Core" base_class_type="my_base::Base"/></library>\n'
}
DESCRIBES = "pluginlib_export_plugin_description_file(my_base plugins.xml)\n"


def package(lines: str, files: dict[str, str] = FILES) -> Example:
    text = CMAKE.replace("ament_package", lines + "ament_package")
    return Example(
        bad={"package.xml": manifest(NEEDS, "ament_cmake"), "CMakeLists.txt": text, **files}, good={}, on="ament_cmake"
    )


def beside_user(example: Example) -> Example:
    """A package beside one that is built with it."""
    return Example(
        bad={**{f"my_pkg/{path}": text for path, text in example.bad_files().items()}, **USERS}, good={}, on=""
    )


CASES = {
    "CMK113": (
        package(LIBRARY),
        package(LIBRARY + TELLS),
        package(LIBRARY + EXTRAS),
        package(LIBRARY + "team_export(core)\n"),
        beside_user(package(LIBRARY)),
        beside_user(package(LIBRARY + TELLS)),
    ),
    "CMK119": (
        package(SET + HEADERS),
        package(SET),
        package(SET + "install(TARGETS core FILE_SET HEADERS)\n"),
        package(SET + BASE.format("INTERFACE")),
        package(SET + HEADERS, NODES),
        package(SET + HEADERS + "target_compile_definitions(core PRIVATE BT_PLUGIN_EXPORT)\n"),
        package(SET + HEADERS + DESCRIBES, DESCRIBED),
        package(SET + HEADERS, DESCRIBED),
        package(SET + HEADERS + DESCRIBES, DESCRIBED | {"plugins.xml": "<library></class>\n"}),
        package(SET + HEADERS + BASE.format("src/base.cpp"), NODES),
        beside_user(package(SET + HEADERS, NODES)),
        beside_user(package(SET)),
    ),
}
