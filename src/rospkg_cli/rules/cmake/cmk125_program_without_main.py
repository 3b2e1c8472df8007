"""CMK125 program-without-main."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cpp.mainless_programs import MainlessPrograms
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Severity
from ...rule import rule

LINES = """\
find_package(rclcpp REQUIRED)
add_executable({} src/talker.cpp)
target_link_libraries(talker PRIVATE rclcpp::rclcpp)
install(TARGETS talker DESTINATION lib/${{PROJECT_NAME}})
"""
TALKER = """\
#include "rclcpp/rclcpp.hpp"

class Talker : public rclcpp::Node
{
public:
  Talker() : Node("talker") {}
};
"""
TO_WRITE = "a comment there says that the code is still to be written"
MAIN = """\

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Talker>());
}
"""


@rule(
    "CMK125",
    "program-without-main",
    over=MainlessPrograms,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "it is built on demand alone; or a source is not there, as one of a submodule, or a library "
        "can't be evaluated, and a file next to the others has a `main()`",
        Severity.INFO: "a comment in a source says that the code is still to be written",
    },
    examples=(
        Example(
            bad={
                "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
                "CMakeLists.txt": CMAKE.replace("ament_package", LINES.format("«talker»") + "ament_package"),
                "src/talker.cpp": TALKER,
            },
            good={"src/talker.cpp": TALKER + MAIN},
            on="ament_cmake",
        ),
    ),
)
def program_without_main(programs: MainlessPrograms) -> Iterator[Hit]:
    """
    ## What it does
    Finds programs of `add_executable()` none of whose sources has a `main()`.
    The file that has it was not listed, or the sources are those of a library: a component, or a class.

    ## Why is this bad?
    All is compiled, and then the linker stops: "undefined reference to `main`".

    ## When it is quiet
    Where a source is not known, or of another language than C++; where one, a header of the package that it includes,
    or a library of the package has `main(`, `MAIN`, BOOST_TEST_MODULE or an unknown macro in it, or includes a file
    called so, and where a library is linked that has `main` in its name (`gtest_main`). Where a source is not there or
    a library can't be evaluated, unless a file next to the others has a `main()` and stands in no CMake file: a
    warning, as for a program that is only built on demand (EXCLUDE_FROM_ALL). For tests, and below a condition that
    can't be evaluated. Where a comment in a source says that the code is still to be written, it is an info.
    """
    for each in programs.all():
        word = each.target.word
        if each.lost:
            advice = f"add `{each.lost}`, which has one and which no target compiles"
        elif each.is_component:
            advice = "make it a library, as the component in it is loaded from one"
        else:
            advice = "add the file that has it, or make a library of the others"
        start = f"no source of `{word.text}` has a `main()`: the linker stops with an undefined reference to it"
        level = Severity.INFO if each.is_left else None if each.is_whole else Severity.WARNING
        yield Hit(word.path, word.span, f"{start}; {TO_WRITE if each.is_left else advice}", level)
