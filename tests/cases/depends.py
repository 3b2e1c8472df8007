"""Dependencies that others bring, or that are declared for another time: levels and fixes."""

from __future__ import annotations

from rospkg_cli.example import CMAKE

from .others import cmake, interfaces, python

TESTS_ONLY = "  <test_depend>launch_ros</test_depend>\n"
LAUNCH = "from launch_ros.actions import Node\n\n\ndef generate_launch_description():\n    return Node\n"
BUILD_ONLY = "  <build_depend>std_msgs</build_depend>\n"

HANDED_ON = cmake("", "  <depend>nobody_knows</depend>\n", cmake__x_DOT_cmake="find_package(std_msgs REQUIRED)\n")
HANDED_ON.bad["CMakeLists.txt"] = CMAKE.replace("ament_package()", "ament_package(CONFIG_EXTRAS cmake/x.cmake)")

CASES = {
    "DEP111": (HANDED_ON,),
    "DEP116": (
        python(
            "  <exec_depend>ament_index_python</exec_depend>\n  <exec_depend>rviz2</exec_depend>\n",
            my_pkg__a_DOT_py="from ament_index_python import get_package_prefix\n\nget_package_prefix('rviz_common')\n",
        ),
    ),
    "DEP115": (
        cmake(
            "add_executable(node src/node.cpp)\ntarget_link_libraries(node yaml-cpp)\n",
            "  <depend>rviz_common</depend>\n",
            src__node_DOT_cpp="int main() {return 0;}\n",
        ),
    ),
    "DEP203": (
        interfaces("float32 x\n", "  <build_depend>message_generation</build_depend>\n"),
        python(
            "  <build_depend>message_generation</build_depend>\n"
            '  <exec_depend condition="$ROS_VERSION == 1">message_generation</exec_depend>\n'
        ),
    ),
    "DEP201": (
        python(TESTS_ONLY, launch__a_DOT_launch_DOT_py=LAUNCH),
        python(BUILD_ONLY + "  <exec_depend>sensor_msgs</exec_depend>\n", my_pkg__a_DOT_py="import std_msgs.msg\n"),
        python(
            "  <exec_depend>ros2launch</exec_depend>\n  <test_depend>joy</test_depend>\n",
            launch__a_DOT_launch_DOT_xml='<launch><node pkg="joy" exec="joy_node"/></launch>\n',
        ),
        cmake(
            "add_executable(node src/node.cpp)\n",
            "  <exec_depend>std_msgs</exec_depend>\n",
            src__node_DOT_cpp="#include <std_msgs/msg/string.hpp>\n",
        ),
        *(
            cmake(f"{lines}\n", f"  <{tag}>{name}</{tag}>\n{more}")
            for lines, tag, name, more in (
                ("find_package(nav2_core REQUIRED)", "exec_depend", "nav2_core", ""),
                ("find_package(rclpy REQUIRED)", "test_depend", "rclpy", ""),
                ("find_package(ament_cmake_python REQUIRED)", "exec_depend", "ament_cmake_python", ""),
                ("find_package(rclpy REQUIRED)", "test_depend", "rclpy", "  <depend>tf2_ros_py</depend>\n"),
                ("find_package(rclpy)", "exec_depend", "rclpy", ""),
                ("find_package(nobody REQUIRED)", "exec_depend", "nobody", ""),
                ("find_package(ament_cmake_gtest REQUIRED)", "test_depend", "ament_cmake_gtest", ""),
                ("if(BUILD_TESTING)\n  find_package(rclpy REQUIRED)\nendif()", "test_depend", "rclpy", ""),
                ("find_package(rclpy REQUIRED)", "build_depend", "rclpy", ""),
            )
        ),
        cmake(
            "find_package(std_msgs REQUIRED)\nadd_executable(node src/node.cpp)\n",
            "  <exec_depend>std_msgs</exec_depend>\n",
            src__node_DOT_cpp="#include <std_msgs/msg/string.hpp>\n",
        ),
        cmake(
            "add_executable(node src/node.cpp)\nif(BUILD_EXAMPLES)\n  add_executable(e src/e.cpp)\nendif()\n",
            "  <exec_depend>std_msgs</exec_depend>\n  <exec_depend>nav_msgs</exec_depend>\n",
            src__node_DOT_cpp="#include <nav_msgs/msg/path.hpp>\n",
            src__e_DOT_cpp="#include <std_msgs/msg/string.hpp>\n#include <nav_msgs/msg/path.hpp>\n",
        ),
        *(
            python(
                "  <test_depend>std_msgs</test_depend>\n  <build_depend>geometry_msgs</build_depend>\n"
                f"  <exec_depend>{bringer}</exec_depend>\n",
                my_pkg__a_DOT_py="import std_msgs.msg\nimport geometry_msgs.msg\n",
            )
            for bringer in ("sensor_msgs", "nobody")
        ),
        cmake(
            "find_package(nav_msgs REQUIRED)\nadd_executable(node src/node.cpp)\n",
            "  <exec_depend>std_msgs</exec_depend>\n  <test_depend>nav_msgs</test_depend>\n"
            "  <depend>sensor_msgs</depend>\n  <depend>nav2_msgs</depend>\n",
            src__node_DOT_cpp="#include <std_msgs/msg/string.hpp>\n",
        ),
        cmake(
            "find_package(yaml-cpp REQUIRED)\nadd_executable(node src/node.cpp)\ntarget_link_libraries(node yaml-cpp)\n"
            "install(TARGETS node DESTINATION lib/${PROJECT_NAME})\n",
            "  <build_depend>yaml-cpp</build_depend>\n",
            src__node_DOT_cpp="",
        ),
        cmake(
            "find_package(yaml-cpp REQUIRED)\nfind_package(rclcpp REQUIRED)\nadd_executable(node src/node.cpp)\n"
            "target_link_libraries(node yaml-cpp rclcpp::rclcpp)\n"
            "install(TARGETS node DESTINATION lib/${PROJECT_NAME})\n",
            "  <build_depend>rclcpp</build_depend>\n  <build_depend>yaml-cpp</build_depend>\n",
            src__node_DOT_cpp="",
        ),
    ),
    "DEP104": (
        cmake("if(BUILD_TESTING)\n  ament_add_gtest(test_a test/a.cpp)\nendif()\n", "", test__a_DOT_cpp=""),
        cmake("find_package(nobody REQUIRED)\nament_add_gmock(test_a test/a.cpp)\n", "", test__a_DOT_cpp=""),
        cmake("ament_add_pytest_test(test_a test/a.py)\n", "", test__a_DOT_py=""),
    ),
}
