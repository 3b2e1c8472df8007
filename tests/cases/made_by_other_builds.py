"""Packages without a build type that a macro of another build system makes, and those that ament makes (XML301)."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest

HEAD = "cmake_minimum_required(VERSION 3.20)\nproject(my_pkg)\nfind_package(ament_cmake REQUIRED)\n"
ELSEWHERE = "include(${ACME_SDK}/acme.cmake)\n"
MADE = "add_acme_package(my_pkg src)\n"
NO_TYPE = manifest("  <buildtool_depend>catkin</buildtool_depend>\n").replace(
    "<build_type>ament_python</build_type>", ""
)
OF_AMENT = NO_TYPE.replace("catkin", "ament_cmake")


def package(lines: str, text: str = NO_TYPE) -> Example:
    files = {"package.xml": text, "CMakeLists.txt": HEAD + lines, "src/core.cpp": "int main() {return 0;}\n"}
    return Example(bad=files, good={}, on="")


CASES = {
    "XML301": (
        package(ELSEWHERE + MADE),
        package(MADE),
        package(ELSEWHERE + MADE, OF_AMENT),
        package(f"{ELSEWHERE}{MADE}ament_package()\n"),
        package(f"{ELSEWHERE}{MADE}install(TARGETS my_pkg DESTINATION lib)\n"),
        package(f"{ELSEWHERE}add_executable(my_pkg src/core.cpp)\n"),
        package(f"macro(add_acme_package)\nendmacro()\n{ELSEWHERE}{MADE}"),
    ),
}
