"""CMK127 manifest-not-installed-by-cmake."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.uninstalled_manifest import uninstalled_manifest
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...package.cmake.cmake_package import CMakePackage
from ...rule import rule

PLAIN = """\
cmake_minimum_required(VERSION 3.20)
project(my_pkg)
add_library(core SHARED src/core.cpp)
«install(TARGETS core DESTINATION lib)»
"""
GOOD = PLAIN.replace("«", "").replace("»", "") + "install(FILES package.xml DESTINATION share/${PROJECT_NAME})\n"


@rule(
    "CMK127",
    "manifest-not-installed-by-cmake",
    over=CMakePackage,
    severity=Severity.INFO,
    examples=(
        Example(
            bad={
                "package.xml": manifest("  <buildtool_depend>cmake</buildtool_depend>\n", "cmake"),
                "CMakeLists.txt": PLAIN,
                "src/core.cpp": "int core() {return 1;}\n",
            },
            good={"CMakeLists.txt": GOOD},
            on="ament_cmake",
        ),
    ),
)
def manifest_not_installed_by_cmake(package: CMakePackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages of the build type `cmake` that install their targets and not their package.xml.

    ## Why is this bad?
    ament_cmake installs package.xml to `share/<package>`; plain CMake does not. `ros2 doctor`, `ros2 pkg xml` and what
    else reads the versions and dependencies of installed packages look there, and find nothing.

    ## When it is quiet
    Where any CMake file names package.xml, where something is installed that can't be evaluated, and where a command
    of ament, catkin or another package may install it.

    ## References
    - REP-136, releasing third party packages
    """
    if call := uninstalled_manifest(package):
        message = (
            f"package.xml is not installed into `share/{package.facts.name}`, as plain CMake does not do so itself: "
            "tools that read versions of installed packages don't find it; add `install(FILES package.xml …)`"
        )
        yield Hit(call.path, call.command.span, message)
