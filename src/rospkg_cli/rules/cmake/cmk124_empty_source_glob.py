"""CMK124 empty-source-glob."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.empty_globs import EmptyGlobs
from ...example import CMAKE, Example
from ...finding import Hit, Severity
from ...package.cmake.cmake_package import CMakePackage
from ...rule import rule

LINES = """\
file(GLOB SOURCES {})
add_executable(talker ${{SOURCES}})
install(TARGETS talker DESTINATION lib/${{PROJECT_NAME}})
"""
SOURCE = {"src/talker.cpp": "int main() {return 0;}\n"}


def cmake(pattern: str) -> str:
    return CMAKE.replace("ament_package", LINES.format(pattern) + "ament_package")


@rule(
    "CMK124",
    "empty-source-glob",
    over=CMakePackage,
    severity=Severity.WARNING,
    levels={Severity.INFO: "no target, interfaces or test is made of these files alone"},
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake("«*.cpp»"), **SOURCE},
            good={"CMakeLists.txt": cmake("src/*.cpp"), **SOURCE},
            on="ament_cmake",
        ),
    ),
)
def empty_source_glob(package: CMakePackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds `file(GLOB …)` whose only pattern matches no file, while another folder holds such files.

    ## Why is this bad?
    CMake says nothing: the variable is empty, and what is made of it lacks its sources, its messages or its tests.
    Relative patterns begin in the folder of the CMakeLists.txt that is read, also below `add_subdirectory()`.

    ## When it is quiet
    For headers, which CMake need not know; for variables that nothing uses, or that an `if(VARIABLE)` asks about; below
    a condition that can't be evaluated; where more than one folder holds such files, and none of these is called as the
    pattern says; and where a .gitignore or a submodule that is not checked out explains it. It is an info unless a
    target, a test or interfaces are made of what is found and of nothing else, headers aside: only these stop.
    """
    for each in EmptyGlobs(package.cmake).all():
        name = package.cmake.source_text(each.word).strip('"')
        message = f"`{name}` matches no file: `{each.variable}` is empty, and CMake does not say so"
        why = "" if each.is_needed else "; nothing here is made of it alone"
        level = None if each.is_needed else Severity.INFO
        yield Hit(each.word.path, each.word.span, f"{message}; did you mean `{each.near}`?{why}", level)
