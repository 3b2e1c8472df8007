# A stand-in: headers with as much of tf2_ros as generated nodes need to compile.
find_package(rclcpp REQUIRED)
find_package(geometry_msgs REQUIRED)
if(NOT TARGET tf2_ros::tf2_ros)
  add_library(tf2_ros::tf2_ros INTERFACE IMPORTED)
  target_include_directories(tf2_ros::tf2_ros INTERFACE "${CMAKE_CURRENT_LIST_DIR}/../../../include")
  target_link_libraries(tf2_ros::tf2_ros INTERFACE rclcpp::rclcpp ${geometry_msgs_TARGETS})
endif()
set(tf2_ros_FOUND TRUE)
