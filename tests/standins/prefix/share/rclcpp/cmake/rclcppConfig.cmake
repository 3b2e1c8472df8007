# A stand-in: headers with as much of rclcpp as generated nodes need to compile.
find_package(rcl_interfaces REQUIRED)
if(NOT TARGET rclcpp::rclcpp)
  add_library(rclcpp::rclcpp INTERFACE IMPORTED)
  target_include_directories(rclcpp::rclcpp INTERFACE "${CMAKE_CURRENT_LIST_DIR}/../../../include")
  target_compile_features(rclcpp::rclcpp INTERFACE cxx_std_17)
  target_link_libraries(rclcpp::rclcpp INTERFACE ${rcl_interfaces_TARGETS})
endif()
set(rclcpp_FOUND TRUE)
