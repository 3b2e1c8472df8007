"""CMK114 unknown-command."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.commands_of_ros1 import CommandsOfRos1
from ...checks.cmake.known_packages import are_all_known
from ...checks.cmake.module_commands import ModuleCommand, ModuleCommands
from ...checks.cmake.unknown_commands import UnknownCommands, is_one_slip
from ...checks.depends.unfound_commands import UnfoundCommand, UnfoundCommands
from ...edits.cmake_find import add_find_package
from ...example import CMAKE, Example
from ...finding import Fix, Hit, Safety, Severity
from ...rule import rule

LINES = """\
add_executable(talker src/talker.cpp)
«target_include_idrectories»(talker PRIVATE include)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
"""
FIND = "find_package(ament_cmake REQUIRED)\n"


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package", lines + "ament_package")


@rule(
    "CMK114",
    "unknown-command",
    over=UnfoundCommands,
    severity=Severity.ERROR,
    levels={
        Severity.INFO: "another package that is found may find the one that defines it, or define it itself: that "
        "package is not known, or the name is two letters or a word off",
    },
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake(LINES), "src/talker.cpp": "int main() {return 0;}\n"},
            good={"CMakeLists.txt": cmake(LINES.replace("«target_include_idrectories»", "target_include_directories"))},
            on="ament_cmake",
        ),
        Example(
            bad={"CMakeLists.txt": CMAKE.replace(FIND, "").replace("ament_package", "«ament_package»")},
            good={"CMakeLists.txt": CMAKE},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
    ),
)
def unknown_command(commands: UnfoundCommands) -> Iterator[Hit]:
    """
    ## What it does
    Finds commands in CMakeLists.txt that are defined nowhere.
    They are nearly called like a known one (of CMake, ament, rosidl and the like, or of the package's own functions;
    near is one or two letters; for commands of ament and rosidl also the same words in another order, or all but the
    last), are of ROS 1 (`catkin_package()`), or come with a package that no `find_package()` looks for:
    `ament_package()` without `find_package(ament_cmake REQUIRED)`. So do commands of modules of CMake that nothing
    includes before: `pkg_check_modules()`, `ExternalProject_Add()`.

    ## Why is this bad?
    CMake stops with "Unknown CMake command".

    ## When it is quiet
    Where a file is included that can't be read: it may define the command. So may, for those of ROS 1, a package that
    is declared or found and has `catkin` in its name. Where a package that is found certainly brings the one that
    defines it, or `ament_lint_auto_find_test_dependencies()` finds what package.xml declares. For names that consist
    of words which commands have (`add_gtest`), names with another number in them (`qt4_wrap_cpp`), and names of less
    than six letters. Under a condition that can't be evaluated, and where the command is never run. For a module of
    CMake where a .cmake file of the package names it. A name that is near to a known one, or is of ROS 1, is an info
    where an unknown package is found, or one of the workspace that has nothing but CMake files for others;
    the first also where two letters or a word are other.
    """
    cmake = commands.package.cmake
    are_known = are_all_known(cmake, commands.missing.declared.workspace)
    for call, near in UnknownCommands(cmake).all():
        is_certain = are_known and is_one_slip(call.name, near)
        message = f"`{call.name}` is no command (did you mean `{near}`?): {stops(is_certain)}; correct the name"
        yield Hit(call.path, call.command.name_span, message, None if is_certain else Severity.INFO)
    of_ros1 = CommandsOfRos1(commands.package, commands.missing.declared.workspace)
    for call, new in of_ros1.all():
        todo = f"call `{new}`" if new else "remove the call"
        message = f"`{call.name}` is a command of ROS 1: {stops(are_known)}; {todo}"
        yield Hit(call.path, call.command.name_span, message, None if are_known else Severity.INFO)
    for of_module in ModuleCommands(cmake).all():
        severity = None if of_module.is_certain else Severity.INFO
        yield Hit(of_module.call.path, of_module.call.command.name_span, not_included(of_module), severity)
    for each in commands.all():
        line = f"find_package({each.package} REQUIRED)"
        edits = add_find_package(cmake, each.package, each.call)
        fix = Fix(f"add {line}", edits) if edits else None
        level = Severity.INFO if each.may_be_brought else None
        yield Hit(each.call.path, each.call.command.name_span, unfound(each, line), level, fix=fix)


def stops(is_certain: bool) -> str:
    return (
        f'CMake stops with "Unknown CMake command"{"" if is_certain else ", unless a package that is found defines it"}'
    )


def not_included(each: ModuleCommand) -> str:
    start = f"`{each.call.name}` comes with CMake's module {each.module}, which nothing includes before"
    if each.is_certain:
        return f'{start}: CMake stops with "Unknown CMake command"; add `{each.finds}`'
    return f"{start}: it is known only as long as a package that is found includes it; add `{each.finds}`"


def unfound(each: UnfoundCommand, line: str) -> str:
    start = f"`{each.call.name}` comes with `{each.package}`, which no `find_package()` finds"
    if each.may_be_brought:
        return f"{start}: it is known only as long as another package finds it; add `{line}`"
    return f'{start}: CMake stops with "Unknown CMake command"; add `{line}`'
