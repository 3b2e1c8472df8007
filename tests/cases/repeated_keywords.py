"""Keywords that stand twice, or late: CMake adds what follows to a list, and of single values it takes the last."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example

TARGETS = "add_executable(a src/a.cpp)\nadd_executable(b src/a.cpp)\nadd_library(core SHARED src/a.cpp)\n"
FILES = {"src/a.cpp": "int main() {return 0;}\n", "config/a.yaml": "{}\n", "config/b.yaml": "{}\n"}


def package(lines: str, files: dict[str, str] | None = None) -> Example:
    text = CMAKE.replace("ament_package", f"{TARGETS}{lines}ament_package")
    return Example(bad={"CMakeLists.txt": text, **FILES, **(files or {})}, good={}, on="ament_cmake")


AGAIN = "install(TARGETS a TARGETS {} DESTINATION lib/my_pkg)\n"

CASES = {
    "CMK110": (
        package(AGAIN.format("b")),
        package(AGAIN.format("c")),
        package("install(TARGETS a OPTIONAL TARGETS b c DESTINATION lib/my_pkg)\n"),
        package("set_property(TARGET a c APPEND PROPERTY COMPILE_OPTIONS -O2)\n"),
        package("set_property(TARGET a b PROPERTY FOLDER c)\nset_property(SOURCE c PROPERTY LANGUAGE C)\n"),
        package("add_custom_command(TARGET c POST_BUILD COMMAND true)\n"),
        package("add_custom_command(TARGET a POST_BUILD COMMAND c)\nadd_custom_command(OUTPUT c COMMAND b)\n"),
        package("add_custom_command(TARGET c POST_BUILD COMMAND true)\nadd_executable(c src/a.cpp)\n"),
    ),
    "CMK104": (
        package("install(TARGETS a b DESTINATION bin DESTINATION lib/my_pkg)\n"),
        package("install(TARGETS a b DESTINATION lib/my_pkg DESTINATION bin)\n"),
    ),
    "CMK102": (
        package("install(FILES config/a.yaml FILES config/b.yaml DESTINATION share/my_pkg)\n"),
        package("install(FILES config/a.yaml FILES config/c.yaml DESTINATION share/my_pkg)\n"),
        package("install(FILES config/a.yaml DESTINATION share/my_pkg FILES config/c.yaml)\n"),
    ),
    "CMK123": (
        package("add_library(more src/a.cpp SHARED)\n"),
        package("add_executable(more src/a.cpp EXCLUDE_FROM_ALL)\n"),
        package("add_library(more EXCLUDE_FROM_ALL SHARED src/a.cpp)\nadd_library(other ${MORE} SHARED src/a.cpp)\n"),
        package("add_library(more src/a.cpp SHARED)\n", {"SHARED": "a file\n"}),
        package("ament_auto_add_library(more src/a.cpp SHARED)\n"),
        package("install(FILES config/a.yaml FILES config/b.yaml DESTINATION share/my_pkg)\n"),
        package("install(FILES config/a.yaml PROGRAMS config/b.yaml DESTINATION share/my_pkg)\n"),
        package("install(FILES config/a.yaml DESTINATION share/my_pkg config/b.yaml)\n"),
        package("install(TARGETS a DESTINATION lib/my_pkg b)\n"),
        package("install(TARGETS a OPTIONAL b DESTINATION lib/my_pkg)\n"),
        package("install(TARGETS a RUNTIME b DESTINATION lib/my_pkg)\n"),
        package("install(TARGETS a RUNTIME DESTINATION lib/my_pkg EXPORT more)\n"),
        package("install(TARGETS a RUNTIME DESTINATION lib/my_pkg TARGETS b)\n"),
        package("install(TARGETS a DESTINATION lib/my_pkg TARGETS b)\n"),
        package("install(TARGETS core EXPORT more LIBRARY DESTINATION lib INCLUDES DESTINATION include x)\n"),
        package("install(TARGETS core LIBRARY DESTINATION lib INCLUDES DESTINATION include EXPORT more)\n"),
        package("install(TARGETS core RUNTIME LIBRARY DESTINATION lib COMPONENT more OPTIONAL)\n"),
        package("install(TARGETS a CONFIGURATIONS Debug Release PERMISSIONS OWNER_READ DESTINATION lib/my_pkg)\n"),
        package("install(TARGETS a ${MORE} DESTINATION lib/my_pkg b)\ninstall(TARGETS a DESTINATION $ENV{TO} b)\n"),
    ),
}
