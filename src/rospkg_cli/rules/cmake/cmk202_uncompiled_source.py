"""CMK202 uncompiled-source."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cpp.uncompiled_sources import UncompiledSource, UncompiledSources
from ...checks.cpp.uncompiled_twins import uncompiled_twins
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Severity
from ...rule import rule

LINES = """\
find_package(rclcpp REQUIRED)
add_executable(talker src/talker.cpp)
target_link_libraries(talker PRIVATE rclcpp::rclcpp)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
"""
NODE = """\
#include <rclcpp/rclcpp.hpp>

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<rclcpp::Node>("talker"));
}
"""
MORE = LINES.replace("talker", "listener").partition("\n")[2]


@rule(
    "CMK202",
    "uncompiled-source",
    over=UncompiledSources,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "no launch file, page or description names what is in it, a program of its name is made of "
        "other files, or nothing that is surely linked needs it"
    },
    examples=(
        Example(
            bad={
                "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
                "CMakeLists.txt": CMAKE.replace("ament_package", LINES + "ament_package"),
                "src/talker.cpp": NODE,
                "src/listener.cpp": NODE.replace("int main(", "«int main»("),
                "README.md": "Run `ros2 run my_pkg listener`.\n",
            },
            good={"CMakeLists.txt": CMAKE.replace("ament_package", LINES + MORE + "ament_package")},
            on="ament_cmake",
        ),
    ),
)
def uncompiled_source(sources: UncompiledSources) -> Iterator[Hit]:
    """
    ## What it does
    Finds C++ files with a node, a component or a plugin that no target of CMake compiles.
    A node is a `main()` that calls `rclcpp::init()`; components and plugins are registered by their macros. It
    also finds those with a member of a class that the header of their name declares and that is defined nowhere else,
    where that header is compiled, or with a function that it declares and that a compiled file calls.

    ## Why is this bad?
    The build is green and passes over the file: `ros2 run` finds no such executable, and nothing can be loaded.
    Where a member is used, the linker stops, or the loader, with an undefined symbol.

    ## When it is quiet
    Where a CMake file has the name of the file anywhere, in a comment too, or another file includes it. In folders of
    tests, examples, demos or third parties, in a file whose name says `template`, `old` or the like, where git ignores
    the file, where the sources of a target can't be evaluated, where a command of another package may add targets, and
    where a Makefile or the like lies around the file, or one at the top names it. Where what uses a member is in a
    static library that nothing links, or in a target that stops at a source of ROS 1, or a compiled library lies in the
    package, nothing may miss it: an info. Where no launch file or page starts the node, and no launch file or
    description that CMake installs or exports names the class, or where a program of the node's name is made of other
    files, the file may be a leftover: an info.
    """
    for each in sources.all():
        existing = sources.existing_program(each)
        message = f"no target in CMakeLists.txt compiles `{each.path}`: {harm(sources, each, existing)}"
        yield Hit(each.path, each.span, message, None if sources.is_wanted(each) and not existing else Severity.INFO)
    for twin in uncompiled_twins(sources):
        yield Hit(twin.path, twin.span, twin.sentence, None if twin.user else Severity.INFO)


def harm(sources: UncompiledSources, each: UncompiledSource, existing: str) -> str:
    """Return what happens as nothing compiles a file, and what to do."""
    if existing:
        return f"it is a leftover, as there is {existing} with other sources; remove it"
    if each.what == "node":
        fails = f"`ros2 run {sources.package.facts.name} {each.name}` finds nothing; add an executable of it"
    else:
        fails = f"the {each.what} can't be loaded; add the file to a library"
    return f"the build passes over it, and {fails}, or remove it"
