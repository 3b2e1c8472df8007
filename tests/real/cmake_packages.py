"""Packages that use much of what CMake and ament can install, and that compile without ROS."""

from __future__ import annotations

MANIFEST = """<?xml version="1.0"?>
<package format="3">
  <name>{name}</name>
  <version>1.2.3</version>
  <description>Installs much.</description>
  <maintainer email="ada@example.org">Ada</maintainer>
  <license>MIT</license>
  <buildtool_depend>ament_cmake_auto</buildtool_depend>
  <export>
    <build_type>ament_cmake</build_type>
  </export>
</package>
"""

COMPILED = """cmake_minimum_required(VERSION 3.16)
project(compiled_pkg)
find_package(ament_cmake REQUIRED)
find_package(ament_cmake_gen_version_h REQUIRED)

add_library(shared_part SHARED src/part.cpp)
add_library(static_part STATIC src/part.cpp)
add_library(module_part MODULE src/part.cpp)
add_library(odd_part SHARED src/part.cpp)
set_target_properties(odd_part PROPERTIES PREFIX "" OUTPUT_NAME oddly SUFFIX ".plugin")
add_library(headers_only INTERFACE)
ament_generate_version_header(shared_part HEADER_PATH compiled_pkg/version.hpp)

foreach(name one two)
  add_executable(${name}_node src/main.cpp)
  list(APPEND nodes ${name}_node)
endforeach()
set_target_properties(two_node PROPERTIES OUTPUT_NAME second)

install(TARGETS shared_part static_part module_part odd_part headers_only
  ARCHIVE DESTINATION lib/archives
  LIBRARY DESTINATION lib
  RUNTIME DESTINATION bin)
install(TARGETS ${nodes} DESTINATION lib/${PROJECT_NAME})
install(DIRECTORY include/ DESTINATION include/${PROJECT_NAME} FILES_MATCHING PATTERN "*.hpp" PATTERN "detail" EXCLUDE)
install(DIRECTORY launch config DESTINATION share/${PROJECT_NAME} REGEX "\\\\.md$" EXCLUDE)
file(GLOB_RECURSE meshes RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" meshes/*.stl)
install(FILES ${meshes} DESTINATION share/${PROJECT_NAME}/meshes)
install(FILES config/a.yaml DESTINATION "${CMAKE_INSTALL_PREFIX}/share/${PROJECT_NAME}" RENAME again.yaml)
configure_file(config/made.yaml.in made.yaml @ONLY)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/made.yaml" DESTINATION share/${PROJECT_NAME})
install(FILES not/there.yaml DESTINATION share/${PROJECT_NAME} OPTIONAL)
if(BUILD_TESTING)
  install(PROGRAMS scripts/check DESTINATION lib/${PROJECT_NAME})
endif()
add_subdirectory(inner)
ament_package(CONFIG_EXTRAS cmake/extras.cmake cmake/more.cmake.in)
"""

INNER = """project(inner)
add_executable(inner_node ../src/main.cpp)
install(TARGETS inner_node RUNTIME DESTINATION lib/compiled_pkg)
install(DIRECTORY data DESTINATION share/compiled_pkg/inner)
"""

SCRIPTED = """cmake_minimum_required(VERSION 3.16)
project(scripted_pkg NONE)
find_package(ament_cmake REQUIRED)
find_package(ament_cmake_python REQUIRED)
ament_python_install_package(${PROJECT_NAME} SCRIPTS_DESTINATION lib/${PROJECT_NAME})
ament_python_install_package(other PACKAGE_DIR python/other_sources)
ament_python_install_module(python/single.py)
ament_get_python_install_dir(place)
install(FILES python/beside.txt DESTINATION "${place}/${PROJECT_NAME}")
function(put)
  cmake_parse_arguments(PUT "" "INTO" "FILES" ${ARGN})
  install(PROGRAMS ${PUT_FILES} DESTINATION lib/${PUT_INTO})
endfunction()
put(INTO ${PROJECT_NAME} FILES scripts/run.py scripts/walk)
ament_package()
"""

SETUP_CFG = """[options.entry_points]
console_scripts =
    spawn = scripted_pkg.spawn:main
    despawn = scripted_pkg.spawn:main
"""

AUTOMATIC = """cmake_minimum_required(VERSION 3.16)
project(automatic_pkg)
find_package(ament_cmake_auto REQUIRED)
ament_auto_find_build_dependencies()
ament_auto_add_library(part SHARED src/part.cpp)
ament_auto_add_executable(node src/main.cpp)
ament_auto_package(INSTALL_TO_SHARE launch config)
"""

SOURCES = {"src/part.cpp": "int part() {return 1;}\n", "src/main.cpp": "int main() {return 0;}\n"}
SCRIPT = "#!/usr/bin/env python3\n"

PACKAGES: dict[str, dict[str, str]] = {
    "compiled_pkg": {
        **SOURCES,
        "CMakeLists.txt": COMPILED,
        "inner/CMakeLists.txt": INNER,
        "inner/data/words.txt": "a\n",
        "include/compiled_pkg/part.hpp": "",
        "include/compiled_pkg/part.txt": "",
        "include/compiled_pkg/detail/hidden.hpp": "",
        "launch/a.launch.py": "",
        "launch/README.md": "",
        "launch/deep/b.launch.xml": "<launch/>",
        "config/a.yaml": "",
        "config/made.yaml.in": "a: @PROJECT_NAME@\n",
        "meshes/base.stl": "",
        "meshes/arm/link.stl": "",
        "meshes/arm/link.txt": "",
        "scripts/check": SCRIPT,
        "cmake/extras.cmake": "",
        "cmake/more.cmake.in": "",
    },
    "scripted_pkg": {
        "CMakeLists.txt": SCRIPTED,
        "setup.cfg": SETUP_CFG,
        "scripted_pkg/__init__.py": "",
        "scripted_pkg/spawn.py": "def main(): ...\n",
        "scripted_pkg/data/words.txt": "",
        "python/other_sources/__init__.py": "",
        "python/other_sources/sub/tool.py": "",
        "python/single.py": "",
        "python/beside.txt": "",
        "scripts/run.py": SCRIPT,
        "scripts/walk": SCRIPT,
    },
    "automatic_pkg": {
        **SOURCES,
        "CMakeLists.txt": AUTOMATIC,
        "include/automatic_pkg/part.hpp": "",
        "launch/a.launch.xml": "<launch/>",
        "config/deep/a.yaml": "",
    },
}
