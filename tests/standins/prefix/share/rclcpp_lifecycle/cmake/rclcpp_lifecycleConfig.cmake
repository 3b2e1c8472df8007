# A stand-in: headers with as much of rclcpp_lifecycle as generated nodes need to compile.
find_package(rclcpp REQUIRED)
if(NOT TARGET rclcpp_lifecycle::rclcpp_lifecycle)
  add_library(rclcpp_lifecycle::rclcpp_lifecycle INTERFACE IMPORTED)
  target_include_directories(rclcpp_lifecycle::rclcpp_lifecycle INTERFACE "${CMAKE_CURRENT_LIST_DIR}/../../../include")
  target_compile_features(rclcpp_lifecycle::rclcpp_lifecycle INTERFACE cxx_std_17)
  target_link_libraries(rclcpp_lifecycle::rclcpp_lifecycle INTERFACE rclcpp::rclcpp)
endif()
set(rclcpp_lifecycle_FOUND TRUE)
