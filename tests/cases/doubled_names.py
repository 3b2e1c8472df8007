"""Libraries that are left out where the name of another one stands twice (CMK103), and silences."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example

LISTED = """\
add_library(near SHARED src/near.cpp)
list(APPEND plugins near)
add_library(far SHARED src/far.cpp)
list(APPEND plugins {})
{}install(TARGETS ${{plugins}} DESTINATION lib)
"""
BOTH = "add_library(near SHARED src/near.cpp)\nadd_library(far {}src/far.cpp)\n"
LOOP = """\
foreach(i 1 2)
  list(APPEND all near)
endforeach()
install(TARGETS ${all} DESTINATION lib)
"""
FILES = dict.fromkeys(("src/near.cpp", "src/far.cpp"), "int far() {return 1;}\n")


def package(lines: str) -> Example:
    text = CMAKE.replace("ament_package", f"{lines}ament_package")
    return Example(bad={"CMakeLists.txt": text, **FILES}, good={}, on="ament_cmake")


CASES = {
    "CMK103": (
        package(LISTED.format("near", "")),
        package(LISTED.format("far", "")),
        package(LISTED.format("near", "install(FILES $<TARGET_FILE:far> DESTINATION lib)\n")),
        package(LISTED.format("near", "target_link_libraries(near far)\n")),
        package(LISTED.format("near", "install(TARGETS far DESTINATION lib)\n")),
        package(LISTED.format("near", "install(TARGETS ${MORE} DESTINATION lib)\nset(MORE ${WHERE}/a)\n")),
        package(LISTED.format("${SOME}/near", "")),
        package(BOTH.format("SHARED ") + "install(TARGETS near near DESTINATION lib)\n"),
        package(BOTH.format("STATIC ") + "install(TARGETS near near DESTINATION lib)\n"),
        package(BOTH.format("SHARED ") + "install(TARGETS near DESTINATION lib)\n"),
        package(BOTH.format("SHARED ") + LOOP),
        package(BOTH.format("SHARED ") + "install(TARGETS near DESTINATION lib)\n" * 2),
    ),
}
