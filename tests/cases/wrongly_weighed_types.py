"""What comes with interfaces of the workspace: the packages of their fields, and those that CMake names."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, INTERFACES_CMAKE, Example, manifest

FINDS = "find_package(geometry_msgs REQUIRED)\nfind_package(my_ifs REQUIRED)\n"
PROGRAM = "add_executable(walk src/walk.cpp)\ntarget_link_libraries(walk my_ifs::my_ifs)\n"
LIBRARY = """\
add_library(core SHARED src/walk.cpp)
target_link_libraries(core PUBLIC ${geometry_msgs_TARGETS} my_ifs::my_ifs)
install(DIRECTORY include/ DESTINATION include)
install(TARGETS core EXPORT core_targets DESTINATION lib)
ament_export_targets(core_targets)
ament_export_dependencies(my_ifs)
"""
INCLUDE = "#include <geometry_msgs/msg/twist.hpp>\n#include <my_ifs/msg/status.hpp>\n"
SOURCES = {"src/walk.cpp": INCLUDE + "int main() {return 0;}\n", "include/my_pkg/walk.hpp": INCLUDE}
BOTH, ONE = (
    "  <depend>geometry_msgs</depend>\n  <depend>the_ifs</depend>\n",
    "  <depend>the_ifs</depend>\n",
)
GENERATED = INTERFACES_CMAKE.replace('  "srv/SetMode.srv"\n', "").replace("my_pkg", "my_ifs")
GIVEN = "  DEPENDENCIES geometry_msgs\n"


def walker(lines: str, field: str, given: str = "", needs: str = BOTH) -> Example:
    """A package with C++, and interfaces whose package.xml does not tell what their fields are of."""
    own = {"package.xml": manifest(needs, "ament_cmake").replace("the_ifs", "my_ifs"), **SOURCES}
    own["CMakeLists.txt"] = CMAKE.replace("ament_package()", f"{lines}ament_package()")
    other = {"package.xml": manifest("", "ament_cmake", "my_ifs"), "msg/Status.msg": f"{field}\n"}
    other["CMakeLists.txt"] = GENERATED.replace('  "msg/Status.msg"\n', f'  "msg/Status.msg"\n{given}')
    files = {**{f"a/{path}": text for path, text in own.items()}, **{f"b/{path}": text for path, text in other.items()}}
    return Example(on="", bad=files, good={})


CASES = {
    "CMK113": (walker(FINDS + LIBRARY, "int8 a"), walker(FINDS + LIBRARY, "geometry_msgs/Twist a")),
    "CMK121": (
        walker(FINDS + PROGRAM, "int8 a"),
        walker(FINDS + PROGRAM, "int8 a", GIVEN),
        walker(FINDS + PROGRAM, "geometry_msgs/Twist a"),
    ),
    "DEP105": (
        walker("find_package(my_ifs REQUIRED)\n" + PROGRAM, "int8 a", "", ONE),
        walker("find_package(my_ifs REQUIRED)\n" + PROGRAM, "geometry_msgs/Twist a", "", ONE),
    ),
}
