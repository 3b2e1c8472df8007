"""CMK114 unknown-command."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.unknown_commands import UnknownCommands
from ...example import CMAKE, Example
from ...finding import Hit, Severity
from ...package.cmake.cmake_package import CMakePackage
from ...rule import rule

LINES = """\
add_executable(talker src/talker.cpp)
«target_include_idrectories»(talker PRIVATE include)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
"""


def cmake(lines: str) -> str:
    return CMAKE.replace("ament_package", lines + "ament_package")


@rule(
    "CMK114",
    "unknown-command",
    over=CMakePackage,
    severity=Severity.ERROR,
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake(LINES), "src/talker.cpp": "int main() {return 0;}\n"},
            good={"CMakeLists.txt": cmake(LINES.replace("«target_include_idrectories»", "target_include_directories"))},
            on="ament_cmake",
        ),
    ),
)
def unknown_command(package: CMakePackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds commands in CMakeLists.txt that nobody defines and that are nearly called like a known one.
    Known are those of CMake, ament, rosidl and the like, and the package's own functions; near is one or two letters.

    ## Why is this bad?
    CMake stops with "Unknown CMake command".

    ## When it is quiet
    Where a file is included that can't be read: it may define the command. For names that consist of words which
    commands have (`add_gtest`), names with another number in them (`qt4_wrap_cpp`), and names of less than six letters.
    Under a condition that can't be evaluated, and where the command is never run.
    """
    for call, near in UnknownCommands(package.cmake).all():
        message = (
            f"`{call.name}` is no command (did you mean `{near}`?): "
            'CMake stops with "Unknown CMake command"; correct the name'
        )
        yield Hit(call.path, call.command.name_span, message)
