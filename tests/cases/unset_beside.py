"""Variables that nothing sets, in a command that is given the intended one, too (CMK115), and others."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example

FOUND = "find_package(Boost REQUIRED)\nfind_package(std_msgs REQUIRED)\nset(ARM_CORE_LIBS m)\n"
CORE = "add_library(core SHARED src/core.cpp)\n"


def package(lines: str) -> Example:
    text = CMAKE.replace("ament_package", FOUND + lines + "\nament_package")
    return Example(bad={"CMakeLists.txt": text, "src/core.cpp": ""}, good={}, on="ament_cmake")


CASES = {
    "CMK115": tuple(
        package(lines)
        for lines in (
            "include_directories(include ${Boost_INCLUDE_DIRS} ${BOOST_INCLUDE_DIRS})",
            "include_directories(include ${Boost_INCLUDE_DIR} ${BOOST_INCLUDE_DIRS})",
            "include_directories(include ${BOOST_INCLUDE_DIRS})\ninclude_directories(${Boost_INCLUDE_DIRS})",
            "include_directories(${STD_MSGS_INCLUDE_DIRS} ${std_msgs_INCLUDE_DIRS})",
            "include_directories(${STD_MSGS_INCLUDE_DIRS}/x ${std_msgs_INCLUDE_DIRS})",
            CORE + "target_link_libraries(core ${STD_MSGS_LIBS} ${std_msgs_LIBRARIES})",
            CORE + "target_link_libraries(core ${ARM_CARE_LIBS} ${ARM_CORE_LIBS})",
            CORE + "target_link_libraries(core ${arm_core_libs} ${ARM_CORE_LIBS})",
            "install(DIRECTORY ${STD_MSGS_INCLUDE_DIRS} DESTINATION ${std_msgs_INCLUDE_DIRS})",
        )
    ),
}
