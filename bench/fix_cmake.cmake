# Read by the real CMake after project(): packages that are not installed are found, with whatever targets are linked.
# Unlike in a build nothing of them is there, but how targets are linked is judged by CMake as ever.  See fix_cmake.py.
#   BENCH_REAL      packages that are left to CMake's own find_package
#   BENCH_THERE     packages that others find on the way
#   BENCH_COMMANDS  commands that nobody defines; they do nothing

macro(bench_provide method name)
  list(FIND BENCH_REAL "${name}" bench_at)
  if(bench_at EQUAL -1)
    set(${name}_FOUND TRUE)
    set(${name}_VERSION "99.0.0")
    set(${name}_INCLUDE_DIRS "/bench/include")
    set(${name}_TARGETS "${name}::${name}")
    set(${name}_LIBRARIES "${name}")
    bench_target(${name}::${name})
  endif()
endmacro()

function(bench_target)
  foreach(item IN LISTS ARGN)
    if(item MATCHES "^[A-Za-z0-9_.+-]+::[A-Za-z0-9_.:+-]+$" AND NOT TARGET ${item})
      add_library(${item} INTERFACE IMPORTED GLOBAL)
    endif()
  endforeach()
endfunction()

cmake_language(SET_DEPENDENCY_PROVIDER bench_provide SUPPORTED_METHODS FIND_PACKAGE)

function(target_link_libraries)
  bench_target(${ARGN})
  _target_link_libraries(${ARGN})
endfunction()

foreach(bench_name IN LISTS BENCH_THERE)
  bench_provide(FIND_PACKAGE ${bench_name})
endforeach()

foreach(bench_command IN LISTS BENCH_COMMANDS)
  cmake_language(EVAL CODE "function(${bench_command})\nendfunction()")
endforeach()

# What packages of ROS define, as far as later commands go by it.
function(generate_parameter_library name)
  add_library(${name} INTERFACE)
endfunction()

function(rosidl_generate_interfaces name)
  add_custom_target(${name})
endfunction()

function(rosidl_get_typesupport_target variable name support)
  if(NOT TARGET ${name}__${support})
    add_library(${name}__${support} INTERFACE IMPORTED GLOBAL)
  endif()
  set(${variable} ${name}__${support} PARENT_SCOPE)
endfunction()

function(rclcpp_components_register_node)
  cmake_parse_arguments(PARSE_ARGV 1 node "" "PLUGIN;EXECUTABLE;EXECUTOR;RESOURCE_INDEX" "")
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/node.cpp" "")
  add_executable(${node_EXECUTABLE} "${CMAKE_CURRENT_BINARY_DIR}/node.cpp")
  install(TARGETS ${node_EXECUTABLE} DESTINATION lib/${PROJECT_NAME})
endfunction()
