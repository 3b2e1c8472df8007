"""CMK110 unknown-target."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.early_references import EarlyReferences
from ...checks.cmake.message_targets import MessageTargets
from ...checks.cmake.mistyped_libraries import MistypedLibraries
from ...checks.cmake.target_references import TargetReferences
from ...checks.cmake.target_sentences import made_below, mistyped, run_together, said, stops
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Related, Severity
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
PLAIN = """\
add_library(my_core SHARED src/core.cpp)
add_executable(talker src/talker.cpp)
target_link_libraries(talker PRIVATE «my_croe»)
install(TARGETS my_core DESTINATION lib)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
"""
SOURCE = "int main() {return 0;}\n"


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package", lines + "ament_package")


@rule(
    "CMK110",
    "unknown-target",
    over=MessageTargets,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "under a condition, or where other files may make it: it is a slip of a long name; or some "
        "distributions have it",
        Severity.INFO: "CMake chooses between ament and catkin, and all sources are of ROS 1; or it waits for a "
        "package that nothing looks for; or names that are run together are exported, and no package here looks for "
        "this one; or a short word of the name is two letters off: another package may have it",
    },
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
        Example(
            bad={
                "CMakeLists.txt": cmake(PLAIN),
                "src/core.cpp": "int core() {return 1;}\n",
                "src/talker.cpp": SOURCE,
            },
            good={"CMakeLists.txt": cmake(PLAIN.replace("«my_croe»", "my_core"))},
            on="ament_cmake",
        ),
    ),
)
def unknown_target(messages: MessageTargets) -> Iterator[Hit]:
    """
    ## What it does
    Finds targets and exports that CMake names and that nothing creates.
    It reads `install(TARGETS)`, `target_link_libraries()` and the like, and exports (`ament_export_targets()`) that no
    `install(… EXPORT …)` fills. Of imported targets (`rclcpp::rclcpp`) it finds those that are one or two letters off,
    those that a package of the workspace does not export, and `std_msgs::std_msgs` and the like, which Lyrical is the
    first to have (`std_msgs` alone is in none); of libraries by a plain name those that are one or two letters off a
    library of the package, and packages of ROS (`rclcpp`) that export a target of another name, where no folder is
    given to the linker. It finds targets that are named above the command that makes them, and in lists of packages two
    names without a space between them.

    ## Why is this bad?
    CMake stops, or the linker does where a library is misspelt. This is what is left when a target was renamed or
    removed.

    ## When it is quiet
    Where a file that can't be read, FetchContent or a submodule may add targets, where a command of another package is
    given the name, for libraries that `find_library()` looks for or that lie in the package, for names with `::` that
    are near to none of a package whose targets are known (of others only their own name with letters swapped, or a long
    one with a letter wrong, is reported), and for `gtest` and `gmock`. For `std_msgs::std_msgs` where no distribution
    before Lyrical is asked for or named alone by the pages, scripts and workflows of the repository. Under a condition
    that can't be evaluated. In the first and the last case, names of eight letters and more that are one or two off one
    that the package makes are reported. Where CMake chooses between ament and catkin and all sources are of ROS 1, a
    target that nothing creates is an info, as is one in a branch for a package that nothing looks for
    (`if(OpenMP_FOUND)`), names run together in an export that no package here meets, and two letters in a short word.
    """
    package = messages.links.package
    for one in messages.all():
        yield Hit(one.word.path, one.word.span, one.sentence, Severity(one.level))
    for each in messages.links.all():
        yield Hit(each.link.word.path, each.link.word.span, mistyped(each), None if each.is_certain else Severity.INFO)
    references = TargetReferences(package.cmake)
    for reference, *others in references.broken_by_name():
        known = references.targets if reference.kind == "target" else references.exports
        near = did_you_mean(reference.word.text, known)
        message = f"{said(package.cmake, reference)}{near}: CMake stops with {stops(reference)}"
        related = tuple(Related(each.word.path, each.word.span, "and here") for each in others)
        level = None if any(map(references.is_certain, (reference, *others))) else Severity.WARNING
        level = Severity.INFO if references.is_met_by_none((reference, *others)) else level
        yield Hit(reference.word.path, reference.word.span, message, level, related)
    for early in EarlyReferences(package.cmake).all():
        yield Hit(early.reference.word.path, early.reference.word.span, made_below(package.cmake, early))
    for word, near, is_certain in MistypedLibraries(package.cmake).all():
        message = f"nothing makes the library `{word.text}` (did you mean `{near}`?): the linker does not find it"
        yield Hit(word.path, word.span, f"{message}; correct it", None if is_certain else Severity.WARNING)
    names = {found.name for found in package.cmake.packages} | {each.name for each in package.manifest.dependencies}
    for reference, first, second in references.run_together(names):
        is_met = "export" not in reference.call.name or bool(messages.consumers.finders)
        message, level = run_together(reference, first, second, is_met), None if is_met else Severity.INFO
        yield Hit(reference.word.path, reference.word.span, message, level)
