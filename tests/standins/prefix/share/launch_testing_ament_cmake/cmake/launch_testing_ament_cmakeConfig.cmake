# A stand-in for what registers launch tests: nothing here could run them, but the file must be there.
set(launch_testing_ament_cmake_FOUND TRUE)

function(add_launch_test file)
  if(NOT EXISTS "${CMAKE_CURRENT_SOURCE_DIR}/${file}")
    message(FATAL_ERROR "Can't find launch test file \"${file}\"")
  endif()
endfunction()
