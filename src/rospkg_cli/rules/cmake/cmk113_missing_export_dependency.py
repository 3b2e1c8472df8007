"""CMK113 missing-export-dependency."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.missing_export_dependencies import ExportedDependencies
from ...edits.cmake_export import export_dependency
from ...edits.plain_names import only_plain_names
from ...example import CMAKE, Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...rule import rule

LINES = """\
find_package(rclcpp REQUIRED)
find_package(std_msgs REQUIRED)

add_library(core SHARED src/core.cpp)
target_include_directories(core PUBLIC
  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
  $<INSTALL_INTERFACE:include/${PROJECT_NAME}>
)
target_link_libraries(core PUBLIC rclcpp::rclcpp «${std_msgs_TARGETS}»)
install(DIRECTORY include/
  DESTINATION include/${PROJECT_NAME}
)
install(TARGETS core EXPORT export_core
  ARCHIVE DESTINATION lib
  LIBRARY DESTINATION lib
  RUNTIME DESTINATION bin
)
ament_export_targets(export_core HAS_LIBRARY_TARGET)
ament_export_dependencies(rclcpp)
"""
GOOD = LINES.replace("«", "").replace("»", "").replace("dependencies(rclcpp", "dependencies(rclcpp std_msgs")
FILES = {
    "package.xml": manifest("  <depend>rclcpp</depend>\n  <depend>std_msgs</depend>\n", "ament_cmake"),
    "src/core.cpp": "#include <my_pkg/core.hpp>\n",
    "include/my_pkg/core.hpp": "#pragma once\n#include <rclcpp/rclcpp.hpp>\n#include <std_msgs/msg/string.hpp>\n",
}


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package", lines + "ament_package")


@rule(
    "CMK113",
    "missing-export-dependency",
    over=ExportedDependencies,
    severity=Severity.WARNING,
    levels={Severity.INFO: "it is a plugin or a component, and no package of the workspace builds against it"},
    examples=(
        Example(
            bad={**FILES, "CMakeLists.txt": cmake(LINES)},
            good={"CMakeLists.txt": cmake(GOOD)},
            on="ament_cmake",
            fix=Safety.UNSAFE,
        ),
    ),
)
def missing_export_dependency(exported: ExportedDependencies) -> Iterator[Hit]:
    """
    ## What it does
    Finds public dependencies of an exported library that `ament_export_dependencies()` does not name.
    A dependency is public if the library is linked with it (PUBLIC, INTERFACE, or without a keyword) and one of its
    installed headers includes it. What comes with a package that is named is left alone. A plugin or a component that
    no package of the workspace builds against may only be loaded.

    ## Why is this bad?
    This package builds. Another one that links the library stops with "the target was not found", or at the first
    `#include` where no target is exported, unless it happens to find the package itself.

    ## Fix safety
    The package is added. Where the library needs it only inside, linking it as PRIVATE is better.
    """
    package = exported.headers.package
    if not package.is_ament:
        return
    for number, each in enumerate(exported.missing()):
        lacks = "a target" if each.is_target else "a header"
        message = (
            f"`{each.link.target}` is exported and passes `{each.package}` on, which `ament_export_dependencies` does "
            f"not name: linking it stops because {lacks} of `{each.package}` was not found; export it"
        )
        edit = export_dependency(package.cmake, each.package, first=number == 0)
        fix = Fix(f"export {each.package}", (edit,), Safety.UNSAFE) if edit else None
        level = Severity.INFO if each.is_only_loaded else None
        yield Hit(each.word.path, each.word.span, message, level, fix=only_plain_names(fix, each.package))
