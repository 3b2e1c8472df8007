"""More faults of CMake and package.xml that people repaired: neighbours of each, and silences."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

from .told_builds import CORE, TOLD, package

MAIN = {"src/a.cpp": "int main() {return 0;}\n", "src/b.cpp": "int main() {return 0;}\n"}
PROGRAMS = "add_executable(a src/a.cpp)\nadd_executable(b src/b.cpp)\ninstall(TARGETS a b {})\n"
TWO = {"launch/a.launch.py": "LAUNCH = 1\n", "launch/b.launch.py": "LAUNCH = 2\n"}
INCLUDES = "add_executable(a src/a.cpp)\ninstall(TARGETS a DESTINATION lib/${PROJECT_NAME})\n"
EIGEN = "  <build_depend>eigen</build_depend>\n"
GENERATES = "find_package(generate_parameter_library REQUIRED)\ngenerate_parameter_library(core config/core.yaml)\n"
BY_GENERATOR = "  <depend>generate_parameter_library</depend>\n"
CODE = {"config/core.yaml": "core:\n  a: {type: int}\n"}
FOLDER = "install(DIRECTORY launch{} DESTINATION share/${{PROJECT_NAME}}/{})\n"
MESSAGES = CMAKE.replace(
    "ament_package()",
    "find_package(geometry_msgs REQUIRED)\nfind_package(std_msgs REQUIRED)\n"
    "find_package(rosidl_default_generators REQUIRED)\n"
    'rosidl_generate_interfaces(${PROJECT_NAME} "msg/Pose.msg" DEPENDENCIES geometry_msgs std_msgs)\nament_package()',
)
GENERATED = """\
  <buildtool_depend>rosidl_default_generators</buildtool_depend>
  <exec_depend>rosidl_default_runtime</exec_depend>
  <member_of_group>rosidl_interface_packages</member_of_group>
"""
TWIN = """\
set(ARM_CORE_DEPS_LIBRARIES dl)
set(ARM_BASE_CORE_DEPS_SYSTEM_LIBRARIES m)
{}add_library(core SHARED src/core.cpp)
target_link_libraries(core PRIVATE ${{ARM_BASE_CORE_DEPS_LIBRARIES}} ${{ARM_BASE_CORE_DEPS_SYSTEM_LIBRARIES}})
install(TARGETS core DESTINATION lib)
"""
CASED = """\
set({} dl)
add_library(core SHARED src/core.cpp)
target_link_libraries(core PRIVATE {})
install(TARGETS core DESTINATION lib)
"""


def messages(needs: str, message: str = "geometry_msgs/Pose2D pose\n") -> Example:
    """A package of one message, and what it declares besides the tools."""
    files = {"CMakeLists.txt": MESSAGES, "msg/Pose.msg": message}
    return Example(bad={**files, "package.xml": manifest(GENERATED + needs, "ament_cmake")}, good={}, on="ament_cmake")


def needs(first: str, second: str) -> str:
    return f"  <{first}>geometry_msgs</{first}>\n  <{second}>std_msgs</{second}>\n"


def linked(words: str, more: str = "") -> Example:
    """A node that includes tf2_geometry_msgs, and what it is linked with."""
    found = "find_package(tf2_ros REQUIRED)\nfind_package(tf2_geometry_msgs REQUIRED)\nset(NEEDS tf2_geometry_msgs)\n"
    lines = f"{found}{more}add_executable(node src/node.cpp)\nament_target_dependencies(node {words})\n"
    files = {"src/node.cpp": "#include <tf2_geometry_msgs/tf2_geometry_msgs.hpp>\nint main() {return 0;}\n"}
    body = "  <depend>tf2_ros</depend>\n  <depend>tf2_geometry_msgs</depend>\n"
    return package(lines, files, body)


CASES = {
    "CMK101": (
        package(GENERATES, {**CODE, "config/robot.yaml": "a: 1\n"}, BY_GENERATOR),
        package(GENERATES, CODE, BY_GENERATOR),
        package("add_custom_target(a config/core.yaml)\n", {**CODE, "config/robot.yaml": "a: 1\n"}),
    ),
    "CMK104": (
        package(PROGRAMS.format("DESTINATION"), MAIN),
        package(PROGRAMS.format("DESTINATION COMPONENT tools"), MAIN),
        package(PROGRAMS.format("RUNTIME DESTINATION"), MAIN),
        package(FOLDER.format("", "launch"), TWO),
        package(FOLDER.format("", "launch/"), TWO),
        package(FOLDER.format("/", "launch"), TWO),
        package(FOLDER.format("", ""), TWO),
        package(FOLDER.format("", "launch") + FOLDER.format("", ""), TWO),
        package(
            FOLDER.format("", "launch"),
            {**TWO, "README.md": "nothing\n", "launch/c.launch.py": "'my_pkg', 'a.launch.py'\n"},
        ),
    ),
    "CMK106": (
        *(
            package(TOLD.format("include/my_pkg", "include", f"{properties}\n"), CORE)
            for properties in (
                "set_target_properties(core PROPERTIES VERSION ${my_pkg_VERSION})",
                "set_target_properties(core PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${WHERE})",
                "set_target_properties(core PROPERTIES ${WHICH} ${WHERE})",
                "set_property(TARGET core PROPERTY VERSION ${my_pkg_VERSION})",
                "set_property(TARGET core APPEND PROPERTY INTERFACE_INCLUDE_DIRECTORIES ${WHERE})",
            )
        ),
    ),
    "CMK114": (
        package("add_rostest_gtest(test_a a.test src/a.cpp)\n", MAIN),
        package("generate_dynamic_reconfigure_options(a.cfg)\n", {}),
        package("find_package(nobody REQUIRED)\nadd_message_files(FILES a.msg)\n", {}),
        package("if(UNKNOWN)\n  catkin_package()\nendif()\n", {}),
        package("find_package(catkin)\ncatkin_package()\n", {}),
        package("macro(add_rostest name)\nendmacro()\nadd_rostest(a.test)\n", {}),
        package("include(${HERE}/own.cmake)\nadd_rostest(a.test)\n", {}),
    ),
    "CMK115": (
        package(TWIN.format(""), CORE),
        package(TWIN.format("include(${HERE}/own.cmake)\n"), CORE),
        package(TWIN.format("set(core_LIBRARIES ${ARM_CORE_DEPS_LIBRARIES})\n"), CORE),
        package(TWIN.format("set(core_LIBRARIES ${${NAME}_DEPS_LIBRARIES})\n"), CORE),
        package(TWIN.format("set(core_LIBRARIES ${${NAME}_DEPS_SOURCES})\n"), CORE),
        package(TWIN.format("find_library(ARM_BASE_CORE_DEPS_LIBRARIES dl)\n"), CORE),
        package(TWIN.format("set(ARM_BASE_DEPS_LIBRARIES dl)\n"), CORE),
        package(CASED.format("Programs", "${PROGRAMS}"), CORE),
        package(CASED.format("Programs", "${PROGRAMS} PROGRAMS"), CORE),
        package(CASED.format("Programs", "${programS}"), CORE),
        package("set(programs core)\n" + CASED.format("Programs", "${PROGRAMS}"), CORE),
        package(CASED.format("LIBS", "${libs}"), CORE),
    ),
    "CMK121": (
        linked("tf2_ros ${needs}"),
        linked("${needs}"),
        linked("${NEEDS}"),
        linked("tf2_ros ${needs}", "set(needs_of_all ${needs})\nlist(APPEND needs tf2_geometry_msgs)\n"),
    ),
    "CMK123": (
        package("install(DIRECTORY launch DESTINATION)\n", TWO),
        package("install(PROGRAMS a.py DESTINATION)\n", {"a.py": "\n"}),
        package("install(FILES a.py DESTINATION ${WHERE})\n", {"a.py": "\n"}),
    ),
    "DEP105": (
        package(INCLUDES, {"src/a.cpp": "#include <eigen3/Eigen/StdVector>\nint main() {return 0;}\n"}),
        package(INCLUDES, {"src/a.cpp": "#include <eigen3/Eigen/StdVector>\nint main() {return 0;}\n"}, EIGEN),
    ),
    "DEP201": (
        messages(needs("buildtool_depend", "depend")),
        messages(needs("build_depend", "exec_depend")),
        messages(needs("depend", "build_depend")),
        messages(needs("build_depend", "build_depend") + "  <exec_depend>nav_msgs</exec_depend>\n"),
        messages(needs("depend", "depend")),
    ),
}
