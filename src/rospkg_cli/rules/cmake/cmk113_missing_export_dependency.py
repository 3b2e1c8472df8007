"""CMK113 missing-export-dependency."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.exported_components import unexported_components
from ...checks.cmake.met_here import by_whom
from ...checks.cmake.missing_export_dependencies import ExportedDependencies
from ...edits.cmake_export import export_dependencies
from ...edits.plain_names import only_plain_names
from ...example import CMAKE, Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
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
    levels={
        Severity.INFO: "no package of the workspace that looks for this one and includes a header of it is known to "
        "lack what is missing"
    },
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
    installed headers includes it, or the library is exported as a target that names one of the dependency, also where
    that is of the system (`yaml-cpp::yaml-cpp`). What comes with a package that is named is left alone. Where Boost is
    exported, it also finds components (`Boost::filesystem`): `ament_export_dependencies(Boost)` asks for none.
    It is a warning where a package of the workspace looks for this one, includes a header and certainly finds what is
    missing in no other way: neither by itself nor with another package, which may look for it in a config of its own.
    For a library that is no exported target it is so where it includes one of the headers that need the other package.
    It is an info elsewhere.

    ## Why is this bad?
    This package builds. Another one that links the library stops with "the target was not found", or at the first
    `#include` where no target is exported, unless it happens to find the package itself.

    ## When it is quiet
    Where CMake or an export can't be evaluated, where a file of CONFIG_EXTRAS names the package, where it is not known
    what comes with a package that is exported (for `arm` that may be an unknown `arm_planning`), for
    `${std_msgs_LIBRARIES}` (paths, not targets), in `ament_auto_package()`, for a plugin that exports only targets, and
    for packages of the system that are declared under another name. All packages that one library lacks are one
    finding.

    ## Fix safety
    The packages are added. Where the library needs one only inside, linking it as PRIVATE is better.
    """
    package = exported.headers.package
    yield from unasked(exported)
    found = list(exported.missing()) if package.is_ament else []
    if not found:
        return
    first, *others = found
    names = [each.package for each in found]
    shown = ", ".join(f"`{name}`" for name in names)
    lacks = "a target" if first.is_target else "a header"
    message = (
        f"`{first.link.target}` is exported and passes {shown} on, which `ament_export_dependencies` does not name: "
        f"linking it stops because {lacks} of `{first.package}` was not found; export {'them' if others else 'it'}"
    )
    related = tuple(Related(each.word.path, each.word.span, f"`{each.package}` is linked here") for each in others)
    edit = export_dependencies(package.cmake, names)
    fix = Fix(f"export {', '.join(names)}", (edit,), Safety.UNSAFE)
    is_met = exported.is_met(found)
    level, message = None if is_met else Severity.INFO, by_whom(message, is_met)
    yield Hit(first.word.path, first.word.span, message, level, related, only_plain_names(fix, *names))


def unasked(exported: ExportedDependencies) -> Iterator[Hit]:
    """Yield the component that users of a target do not find."""
    for each in unexported_components(exported):
        start = f"`{each.target}` is exported and passes `{each.name}` on, and exporting `{each.package}` asks for no"
        end = "component: linking it stops because this target was not found; find it in a file of CONFIG_EXTRAS"
        is_met = each.is_certain and exported.consumers.lack_any([each.package])
        yield Hit(each.word.path, each.word.span, by_whom(f"{start} {end}", is_met), None if is_met else Severity.INFO)
