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

OFF = "".join(f"# {line}\n" for line in (CMAKE + "add_library(core src/core.cpp)\n").splitlines())
HEAD = "cmake_minimum_required(VERSION 3.20)\nproject(my_pkg)\n"
AROUND = (
    OFF,
    HEAD + OFF,
    f"#[[\n{CMAKE}]]\n",
    "add_library(core src/tests.cpp)\n" + OFF,
    f"{HEAD}install(FILES package.xml DESTINATION share/my_pkg)\n{OFF}",
    "",
    "# a package\n",
    f"{HEAD}# ament_package comes later\n",
)
"""What is left of CMakeLists.txt where all or a part of it stands in comments."""

CASES = {
    "CMK003": (
        *(Example(bad={"CMakeLists.txt": text, **FILES}, good={}, on="") for text in AROUND),
        *(Example(bad={"CMakeLists.txt": BUILT + line, **FILES}, good={}, on="") for line in LINES),
        Example(bad={"CMakeLists.txt": CMAKE.replace("ament_package()", ""), **FILES}, good={}, on=""),
    ),
}
