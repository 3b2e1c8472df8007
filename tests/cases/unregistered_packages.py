"""Packages without `ament_package()` that hand on something, and those that are only built (CMK003)."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

BUILT = CMAKE.replace("ament_package()", "add_executable(unit_tests src/tests.cpp)\n")
LINES = (
    "",
    "install(TARGETS unit_tests DESTINATION lib/my_pkg)\n",
    "ament_export_dependencies(rclcpp)\n",
    'rosidl_generate_interfaces(my_pkg "msg/A.msg")\n',
    "ament_python_install_package(my_pkg)\n",
)
FILES = {"src/tests.cpp": "int main() {return 0;}\n", "package.xml": manifest("", "ament_cmake")}

CASES = {
    "CMK003": (
        *(Example(bad={"CMakeLists.txt": BUILT + line, **FILES}, good={}, on="") for line in LINES),
        Example(bad={"CMakeLists.txt": CMAKE.replace("ament_package()", ""), **FILES}, good={}, on=""),
    ),
}
