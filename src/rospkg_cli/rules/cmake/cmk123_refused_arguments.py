"""CMK123 refused-arguments."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.empty_operands import EmptyOperand, EmptyOperands
from ...checks.cmake.refused_arguments import refused_calls
from ...checks.cmake.source_includes import source_includes
from ...checks.cmake.written_slips import WrittenSlips
from ...checks.repository.linked_build import is_always_linked
from ...example import CMAKE, Example
from ...finding import Hit, Related, Severity
from ...package.cmake.cmake_package import CMakePackage
from ...rule import rule

SOURCE = {"src/core.cpp": "int core() {return 1;}\n", "src/core.hpp": "int core();\n"}
LAUNCH = {"launch/talker.launch.xml": "<launch/>\n"}
INCLUDED = """\
add_library(core SHARED src/core.cpp)
target_include_directories(core {}src)
install(TARGETS core DESTINATION lib)
"""
LINKED = """\
add_library(core SHARED src/core.cpp)
target_link_libraries(core {}m)
install(TARGETS core DESTINATION lib)
"""
SWITCH = """\
set(with_camera {})
if(with_camera)
  message(STATUS "with a camera")
endif()
"""


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package", f"{lines}ament_package")


@rule(
    "CMK123",
    "refused-arguments",
    over=CMakePackage,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "under a condition that can't be evaluated, or CMake goes on with another value, or a "
        "condition compares what is empty for some, or each documented build command has `--symlink-install`, "
        "with which a second `DIRECTORY` is read as it is intended",
        Severity.INFO: "what it compares is set wherever ROS is set up, or the condition stands in a block; or no "
        "linker runs for what is linked, or a folder without its slash is not needed",
    },
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake(INCLUDED.format("«").replace("src)", "src»)")), **SOURCE},
            good={"CMakeLists.txt": cmake(INCLUDED.format("PRIVATE ")), **SOURCE},
            on="ament_cmake",
        ),
        Example(
            bad={"CMakeLists.txt": cmake("install(DIRECTORY launch «RUNTIME» DESTINATION share/my_pkg)\n"), **LAUNCH},
            good={"CMakeLists.txt": cmake("install(DIRECTORY launch DESTINATION share/my_pkg)\n"), **LAUNCH},
            on="ament_cmake",
        ),
        Example(
            bad={"CMakeLists.txt": cmake(SWITCH.format("«flase»"))},
            good={"CMakeLists.txt": cmake(SWITCH.format("FALSE"))},
            on="ament_cmake",
        ),
        Example(
            bad={"CMakeLists.txt": cmake(LINKED.format("«SHARED» ")), **SOURCE},
            good={"CMakeLists.txt": cmake(LINKED.format("PRIVATE ")), **SOURCE},
            on="ament_cmake",
        ),
    ),
)
def refused_arguments(package: CMakePackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds calls whose arguments CMake refuses, or takes for something else than is intended.
    It knows `target_include_directories()` and its like without `PUBLIC`, `PRIVATE` or `INTERFACE`,
    `install(FILES …)` without a destination or with a keyword of another form, what stands behind the value of a
    keyword (`install(TARGETS a DESTINATION bin b)`), `EXPORT` in the part of `RUNTIME` and its like,
    options behind the sources of a target (`add_library(core core.cpp SHARED)`),
    `target_link_libraries(x SHARED …)`, commands that are given too few arguments, such as
    `pluginlib_export_plugin_description_file()`, folders of the source tree that an exported target names to its users
    (`target_include_directories(x PUBLIC include)`), and definitions among the compiler's options
    (`add_compile_options(WITH_ARM=1)`). It also
    finds `flase`, `${CMAKE_CURRENT_SOURCE_DIR}scripts` where the slash is missing, and operands of conditions that may
    be empty and stand without quotes: `$ENV{ROS_DISTRO}`, `${CMAKE_BUILD_TYPE}`.

    ## Why is this bad?
    CMake stops at once, or the build does when it links or installs: CMake takes a keyword that a command does not know
    for one more file or library.

    ## When it is quiet
    Where an argument is a variable that can't be evaluated, for a command that the package defines itself, and for a
    target, file or folder that is called like the keyword. For an operand that a file sets or asks for
    (`if(DEFINED ENV{NAME})`), and one of ROS where package.xml names ros_environment.
    A folder without its slash is an info where the headers of it that are included are found next to the file or in
    another folder, where it should have libraries and has none, and where nothing reads the variable.
    `target_link_libraries(x SHARED …)` is an info for a static library with which nothing is linked here:
    `add_library(x …)` makes one, unless ament_cmake_ros or BUILD_SHARED_LIBS says otherwise.
    """
    for each in (*refused_calls(package.cmake), *source_includes(package.cmake)):
        place = each.word.span if each.word else each.call.command.name_span
        is_met = each.is_linked and is_always_linked(package.cmake.package_files, package.facts.name)
        level = Severity.WARNING if is_met or each.call.maybe or (each.word and each.word.maybe) else None
        places = dict.fromkeys((word.path, word.span) for word in each.others)
        related = tuple(Related(*other, "and here") for other in places)
        yield Hit(each.call.path, place, each.message, Severity.INFO if each.is_idle else level, related)
    for value in WrittenSlips(package.cmake).all():
        yield Hit(value.call.path, value.span, value.message, Severity.INFO if value.why_harmless else Severity.WARNING)
    for operand in EmptyOperands(package).all():
        level = Severity.INFO if operand.is_mostly_set or operand.is_inner else Severity.WARNING
        yield Hit(operand.path, operand.argument.span, without_quotes(operand), level)


def without_quotes(operand: EmptyOperand) -> str:
    text = operand.argument.text
    inner = "; the condition stands in a block that CMake may not come to" if operand.is_inner else ""
    fails = f"where `{text}` is empty, the condition lacks an argument and CMake stops"
    return f'{fails}; write it in quotes: `"{text}"`{inner}'
