"""CMK126 lost-dollar."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.lost_dollars import LostDollars
from ...example import CMAKE, Example
from ...finding import Hit, Severity
from ...package.cmake.cmake_package import CMakePackage
from ...rule import rule

LINES = """\
add_library(core SHARED src/core.cpp)
target_include_directories(core PRIVATE {}/include)
install(TARGETS core DESTINATION lib)
"""
SOURCE = {"src/core.cpp": '#include "core.hpp"\nint core() {return 1;}\n', "include/core.hpp": "int core();\n"}


def cmake(folder: str) -> str:
    return CMAKE.replace("ament_package", f"{LINES.format(folder)}ament_package")


@rule(
    "CMK126",
    "lost-dollar",
    over=CMakePackage,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "what is exported in a folder below that of `ament_package()` goes nowhere in any case, or "
        "`ament_auto_package()` installs the targets, too; or a folder is not needed, or nothing reads what is set"
    },
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake("«{CMAKE_CURRENT_SOURCE_DIR}»"), **SOURCE},
            good={"CMakeLists.txt": cmake("${CMAKE_CURRENT_SOURCE_DIR}")},
            on="ament_cmake",
        ),
    ),
)
def lost_dollar(package: CMakePackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds variables in CMakeLists.txt that are written without their dollar sign or with wrong braces.
    It knows `{NAME}`, `{$NAME}`, `$(NAME)` and `$NAME`, where CMake or the package sets a variable of that name.

    ## Why is this bad?
    CMake has variables as `${NAME}` alone. All else is plain text: a path with it does not exist, or a folder of that
    very name is made, and a list is one odd word.

    ## When it is quiet
    In `message()`, `string()`, `file()` and conditions, whose texts may mean braces, in what a shell, Make or a test
    gets (`add_custom_command()`, `add_test()`), for `$ORIGIN` and `$LIB`, which the loader reads, in `[[…]]`, and
    behind a backslash. It is an info where a folder of headers or libraries is not needed, as all that is included is
    found otherwise, and where nothing reads the variable that is set.
    """
    for each in LostDollars(package.cmake).all():
        yield Hit(each.call.path, each.span, each.sentence, None if each.has_effect else Severity.INFO)
