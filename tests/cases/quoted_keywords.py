"""Keywords in quotes: a command of CMake gets them as those without."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

MACRO = """\
macro(add_my_test name)
  cmake_parse_arguments(_ARG "SKIP_TEST" "TIMEOUT" "SRCS;ENV;APPEND_LIBRARY_DIRS" ${{ARGN}})
  if(_ARG_APPEND_LIBRARY_DIRS)
    set(_ARG_APPEND_LIBRARY_DIRS "APPEND_LIBRARY_DIRS" ${{_ARG_APPEND_LIBRARY_DIRS}})
  endif()
  if(_ARG_SKIP_TEST)
    set(_ARG_SKIP_TEST "SKIP_TEST")
  else()
    set(_ARG_SKIP_TEST "")
  endif()
  ament_add_gtest(${{name}} ${{_ARG_SRCS}} ${{_ARG_APPEND_LIBRARY_DIRS}} ${{_ARG_SKIP_TEST}})
endmacro()
if(BUILD_TESTING)
  find_package(ament_cmake_gtest REQUIRED)
  add_my_test(test_a {})
endif()
"""
MAIN = "int main() {return 0;}\n"


def package(lines: str) -> Example:
    files = {
        "package.xml": manifest("  <test_depend>ament_cmake_gtest</test_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}ament_package"),
        "test/a.cpp": MAIN,
    }
    return Example(bad=files, good={}, on="ament_cmake")


CASES = {
    "CMK102": (
        package(MACRO.format("SRCS test/a.cpp APPEND_LIBRARY_DIRS ${MY_FOLDER} lib")),
        package(MACRO.format('SRCS test/a.cpp "APPEND_LIBRARY_DIRS" lib SKIP_TEST')),
        package(MACRO.format("SRCS test/b.cpp APPEND_LIBRARY_DIRS lib")),
        package('ament_add_gtest(test_a test/a.cpp "ENV" A=b "TIMEOUT" 60 "RUNNER" run.py)\n'),
        package('add_executable(a "EXCLUDE_FROM_ALL" test/a.cpp)\nadd_library(b "SHARED" test/a.cpp)\n'),
        package('install(FILES test/a.cpp "DESTINATION" share/my_pkg "COMPONENT" more)\n'),
        package('install(DIRECTORY shared "DESTINATION" share/my_pkg "FILES_MATCHING" "PATTERN" "*.hpp")\n'),
    ),
    "CMK120": (package('add_library(b test/a.cpp)\ninstall(TARGETS b "LIBRARY" "DESTINATION" LIBRAR)\n'),),
    "CMK104": (
        package('add_executable(a test/a.cpp)\ninstall(TARGETS a "RUNTIME" "DESTINATION" lib/my_pkg)\n'),
        package('add_executable(a test/a.cpp)\ninstall(TARGETS a "RUNTIME" "DESTINATION" bin)\n'),
    ),
}
