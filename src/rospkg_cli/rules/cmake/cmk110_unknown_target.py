"""CMK110 unknown-target."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.mistyped_links import MistypedLink, MistypedLinks
from ...checks.cmake.target_references import TargetReference, TargetReferences
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Severity
from ...package.cmake.cmake_package import CMakePackage
from ...rule import rule
from ...suggest import did_you_mean

TARGET = """\
add_executable(talker src/talker.cpp)
target_compile_features(«talkr» PRIVATE cxx_std_17)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
"""
EXPORT = """\
add_library(core SHARED src/core.cpp)
install(TARGETS core EXPORT core_targets DESTINATION lib)
ament_export_targets(«export_core»)
"""
IMPORTED = """\
find_package(rclcpp REQUIRED)
add_executable(talker src/talker.cpp)
target_link_libraries(talker «rclcpp::rclpcp»)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
"""
SOURCE = "int main() {return 0;}\n"

STOPS = {
    "install": "given target … which does not exist",
    "set_target_properties": "can not find target to add properties to",
    "add_dependencies": "Cannot add target-level dependencies to non-existent target",
    "ament_target_dependencies": "the first argument must be a valid target name",
    "rosidl_target_interfaces": "the first argument … must be a valid target name",
}
"""How CMake says it; the commands for targets all end their sentence in the same way."""


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package", lines + "ament_package")


@rule(
    "CMK110",
    "unknown-target",
    over=MistypedLinks,
    severity=Severity.ERROR,
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake(TARGET), "src/talker.cpp": SOURCE},
            good={"CMakeLists.txt": cmake(TARGET.replace("«talkr»", "talker"))},
            on="ament_cmake",
        ),
        Example(
            bad={"CMakeLists.txt": cmake(EXPORT), "src/core.cpp": "int core() {return 1;}\n"},
            good={"CMakeLists.txt": cmake(EXPORT.replace("«export_core»", "core_targets"))},
            on="ament_cmake",
        ),
        Example(
            bad={
                "CMakeLists.txt": cmake(IMPORTED),
                "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
                "src/talker.cpp": SOURCE,
            },
            good={"CMakeLists.txt": cmake(IMPORTED.replace("«rclcpp::rclpcp»", "rclcpp::rclcpp"))},
            on="ament_cmake",
        ),
    ),
)
def unknown_target(links: MistypedLinks) -> Iterator[Hit]:
    """
    ## What it does
    Finds targets and exports that CMake names and that nothing creates.
    It reads `install(TARGETS)`, `target_link_libraries()` and the like, and exports (`ament_export_targets()`) that no
    `install(… EXPORT …)` fills. Of imported targets (`rclcpp::rclcpp`) it finds those that are one or two letters off,
    and those that a package of the workspace does not export.
    In lists of packages it finds two names without a space between them.

    ## Why is this bad?
    CMake stops. This is what is left when a target was renamed or removed.

    ## When it is quiet
    Where a file that can't be read, FetchContent or a submodule may add targets, where a command of another package is
    given the name, for names with `::` that are near to none of a package whose targets are known (of others only
    their own name with letters swapped is told), and for `gtest` and `gmock`.
    Under a condition that can't be evaluated.
    """
    package = links.package
    for each in links.all():
        yield Hit(each.link.word.path, each.link.word.span, mistyped(each))
    references = TargetReferences(package.cmake)
    for reference in references.broken():
        known = references.targets if reference.kind == "target" else references.exports
        near = did_you_mean(reference.word.text, known)
        message = f"{said(package, reference)}{near}: CMake stops with {stops(reference)}"
        yield Hit(reference.word.path, reference.word.span, message)
    names = {found.name for found in package.cmake.packages} | {each.name for each in package.manifest.dependencies}
    for reference, first, second in references.run_together(names):
        start = f"`{reference.word.text}` is no package, but `{first}` and `{second}` without a space between them"
        message = f"{start}: users of this package stop because it is not found; separate them"
        yield Hit(reference.word.path, reference.word.span, message)


def mistyped(each: MistypedLink) -> str:
    text = each.link.word.text
    if each.exported is not None:
        package = text.partition("::")[0]
        there = f"`{each.exported[0]}`" if each.exported else "no target"
        advice = "link that" if each.exported else "export it there with `ament_export_targets(…)`"
        return (
            f"`{package}` exports {there}{' and others' if each.exported[1:] else ''}, not `{text}`: CMake stops with "
            f'"the target was not found"; {advice}'
        )
    return (
        f"no package makes the target `{text}` (did you mean `{each.near}`?): CMake stops with "
        '"the target was not found"; correct it'
    )


def said(package: CMakePackage, reference: TargetReference) -> str:
    name = package.cmake.quoted(reference.word)
    if reference.kind == "export":
        return f"no `install(… EXPORT …)` fills {name}, which `{reference.call.name}` exports"
    return f"`{reference.call.name}` names the target {name}, which nothing creates"


def stops(reference: TargetReference) -> str:
    if reference.kind == "export":
        return f'"INSTALL(EXPORT) given unknown export"; add `EXPORT {reference.word.text}` to the `install(TARGETS …)`'
    text = STOPS.get(reference.call.name, "which is not built by this project")
    return f'"{text}"; name an existing target'
