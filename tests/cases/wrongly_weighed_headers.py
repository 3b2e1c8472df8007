"""Headers that other packages do not find: who of the workspace includes them, and who has copies."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

LIBRARY = """\
include_directories(include)
add_library(core SHARED src/core.cpp)
{}install(DIRECTORY include DESTINATION include)
install(TARGETS core DESTINATION lib)
ament_export_include_directories(include)
ament_export_libraries(core)
"""
PROGRAM = "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
NONE = LIBRARY.replace("install(DIRECTORY include DESTINATION include)\n", "")
USER = "find_package(my_pkg REQUIRED)\nadd_executable(user src/user.cpp)\nament_target_dependencies(user my_pkg)\n"
MAIN = "int main() {return 0;}\n"
HEADER = "#pragma once\nint core();\n"
CORE = '#include "my_pkg/core.hpp"\n'


def cmake(lines: str, name: str = "my_pkg") -> str:
    return CMAKE.replace("ament_package", f"{lines}ament_package").replace("my_pkg)", f"{name})", 1)


def library(lines: str, user: str | None = None, *, has_copy: bool = False) -> Example:
    """A package with headers, and one that is built against it, whose source begins with some text."""
    files = {
        "a/package.xml": manifest("", "ament_cmake"),
        "a/CMakeLists.txt": cmake(lines),
        "a/include/my_pkg/core.hpp": HEADER,
        "a/src/core.cpp": f"{CORE}int core() {{return 1;}}\n",
        "a/src/talker.cpp": MAIN,
    }
    if user is not None:
        body = manifest("  <depend>the_pkg</depend>\n", "ament_cmake", "user_pkg").replace("the_pkg", "my_pkg")
        files |= {"b/package.xml": body, "b/CMakeLists.txt": cmake(USER, "user_pkg"), "b/src/user.cpp": user + MAIN}
        files |= {"b/include/my_pkg/core.hpp": HEADER} if has_copy else {}
    return Example(on="", bad=files, good={})


def exported(name: str) -> Example:
    text = CMAKE.replace("ament_package", f"{PROGRAM}ament_export_libraries({name})\nament_package")
    return Example(on="ament_cmake", bad={"CMakeLists.txt": text, "src/talker.cpp": MAIN}, good={})


CASES = {
    "CMK106": (
        *(library(lines.format(more)) for lines in (LIBRARY, NONE) for more in ("", PROGRAM)),
        *(
            library(lines.format(PROGRAM), text, has_copy=has_copy)
            for lines in (LIBRARY, NONE)
            for text in (CORE, "#include <vector>\n", "#include <rclcpp/rclcpp.hpp>\n")
            for has_copy in (False, True)
        ),
    ),
    "CMK118": (exported("talker"),),
}
