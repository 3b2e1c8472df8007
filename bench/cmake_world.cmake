# Read by the real CMake after project(): what no package of this machine answers is answered here, so that a package
# can be configured whose dependencies are not installed.  See cmake_world.py.
#   BENCH_REAL      packages that are left to CMake's own find_package
#   BENCH_STUBS     a folder of <package>.cmake: what the real package's CMake extras define
#   BENCH_COMMANDS  commands that nobody defines; they do nothing

cmake_policy(VERSION 3.24)

macro(bench_provide method name)
  if(NOT "${name}" IN_LIST BENCH_REAL)
    set(${name}_FOUND TRUE)
    string(TOUPPER "${name}" bench_upper)
    set(${bench_upper}_FOUND TRUE)
    set(${name}_VERSION "99.0.0")
    set(${name}_INCLUDE_DIRS "/bench/include")
    set(${name}_LIBRARIES "${name}::${name}")
    set(${name}_TARGETS "${name}::${name}")
    if(NOT TARGET ${name}::${name})
      add_library(${name}::${name} INTERFACE IMPORTED GLOBAL)
    endif()
    if(NOT ${name}_DIR)
      set(${name}_DIR "/bench/share/${name}/cmake")
    endif()
    if(EXISTS "${BENCH_STUBS}/${name}.cmake" AND NOT bench_included_${name})
      set(bench_included_${name} TRUE)
      include("${BENCH_STUBS}/${name}.cmake")
    endif()
  endif()
endmacro()
cmake_language(SET_DEPENDENCY_PROVIDER bench_provide SUPPORTED_METHODS FIND_PACKAGE)

# The libraries are not there: who links what is read from the trace.
function(target_link_libraries)
endfunction()

# Neither are the files that a package looks for.
foreach(bench_command find_library find_path)
  cmake_language(EVAL CODE "
    function(${bench_command} variable)
      set(arguments \${ARGN})
      list(REMOVE_ITEM arguments REQUIRED)
      _${bench_command}(\${variable} \${arguments})
      if(NOT \${variable} AND NOT CMAKE_CURRENT_LIST_DIR MATCHES \"^\${CMAKE_ROOT}\")
        set(\${variable} /bench/found CACHE FILEPATH \"\" FORCE)
      endif()
    endfunction()")
endforeach()

foreach(bench_command ${BENCH_COMMANDS})
  cmake_language(EVAL CODE "function(${bench_command})\nendfunction()")
endforeach()
