# A stand-in: headers with as much of geometry_msgs as generated nodes need to compile.
find_package(std_msgs REQUIRED)
set(geometry_msgs_TARGETS ${std_msgs_TARGETS})
set(geometry_msgs_FOUND TRUE)
