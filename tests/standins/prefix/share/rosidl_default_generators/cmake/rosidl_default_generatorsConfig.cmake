# A stand-in: Debian has rosidl with its generators for C and C++, but not this package, which names them.
find_package(ament_cmake_core REQUIRED)
find_package(rosidl_cmake REQUIRED)
find_package(rosidl_generator_c REQUIRED)
find_package(rosidl_generator_cpp REQUIRED)
set(rosidl_default_generators_FOUND TRUE)
