# A stand-in: headers with as much of rclcpp_action as generated nodes need to compile.
find_package(rclcpp REQUIRED)
if(NOT TARGET rclcpp_action::rclcpp_action)
  add_library(rclcpp_action::rclcpp_action INTERFACE IMPORTED)
  target_include_directories(rclcpp_action::rclcpp_action INTERFACE "${CMAKE_CURRENT_LIST_DIR}/../../../include")
  target_compile_features(rclcpp_action::rclcpp_action INTERFACE cxx_std_17)
  target_link_libraries(rclcpp_action::rclcpp_action INTERFACE rclcpp::rclcpp)
endif()
set(rclcpp_action_FOUND TRUE)
