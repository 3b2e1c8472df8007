"""DEP105 undeclared-include."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.name_source import is_unmet
from ...checks.depends.undeclared_includes import IncludeDependencies
from ...edits.brought_hits import brought_includes, left_to_others, related, tag_of
from ...edits.undeclared_dependency import advice, declaration
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Safety, Severity
from ...rule import rule

NODE = CMAKE.replace(
    "ament_package()",
    "add_executable(node src/node.cpp)\ninstall(TARGETS node DESTINATION lib/${PROJECT_NAME})\nament_package()",
)


BUILD_ENDS, CMAKE_STOPS = 'the build ends with "No such file or directory"', "CMake, which requires it, stops"
MAIN = "int main() {return 0;}\n"


@rule(
    "DEP105",
    "undeclared-include",
    over=IncludeDependencies,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "where a dependency brings it, or may bring it, as an empty submodule may, a page says to "
        "install it by hand, an unreleased repository declares it in another package or installs it by apt, "
        "package.xml has it in a comment or for older distributions alone, or no file that includes it is compiled, "
        "or installed where a package of the workspace builds against this one, or it needs this one itself"
    },
    examples=(
        Example(
            on="ament_cmake",
            bad={
                "CMakeLists.txt": NODE,
                "src/node.cpp": "#include <«std_msgs/msg/string.hpp»>\nint main() {return 0;}\n",
            },
            good={"package.xml": manifest("  <depend>std_msgs</depend>\n", "ament_cmake")},
            fix=Safety.SAFE,
        ),
    ),
)
def undeclared_include(includes: IncludeDependencies) -> Iterator[Hit]:
    """
    ## What it does
    Finds C++ includes of other packages and libraries that package.xml does not declare.
    ROS packages are checked, libraries that have a rosdep key, and generated types (`nav_msgs::msg::Odometry`) whose
    header another one includes.

    ## Why is this bad?
    The header is found only as long as another dependency brings it. The day that one changes, or on a machine where
    it is not installed, the build ends with "No such file or directory"; in a workspace colcon may build it too early.

    ## When it is quiet
    What a declared dependency or a package or module that CMake requires certainly installs, or may, is one info, which
    names who brings it, and DEP104's where CMake requires such a package, too. So is what only files include that an
    option of CMake must ask for, or only headers that are not compiled, where others are, or no package of the
    workspace includes a header of this one, or that are not installed. Files that no target compiles, or that no CMake
    file names where it names others of the folder one by one, includes under `#if` (unless it asks for a macro that
    CMake defines in any case), headers that all others include under it, neighbours whose folder CMake names
    (`include_directories(../other/include)`), what CMake fetches, packages that `find_package()` names as well
    (DEP104), and headers that CMake finds in a package inside of this one are left alone. So are libraries that a git
    submodule is named after, checked out or not, and those that CMake looks for without need, where only what includes
    them waits for it, what is declared under a condition that does not hold (`$ROS_VERSION == 1`), where no build is
    sure to compile what includes it, and types whose package comes with another undeclared one. What an empty submodule
    that CMake looks into may hold is an info, and a library that a page or a comment of CMake says to install by hand,
    or whose headers lie in a folder of their own (`$ENV{MODBUS_ROOT}/include`), or that CMake takes from /usr/local or
    /opt, and what another package of the repository declares, or a list or a command of it installs (apt alone), where
    nothing shows a release. So is what only targets include that stop at a source of ROS 1 before. Headers of ROS 1
    (`std_msgs/String.h`), and others that no package of interfaces has, come with no declaration: CMK201 reports them.
    A package here that needs this one itself is an info, for to declare it would make a circle; where it declares this
    one, nothing is said.

    ## Fix safety
    The fix is unsafe where no released package has the name, or a comment of package.xml leaves it out.

    ## References
    - REP-149, depend
    """
    declared, including = includes.declared, includes.including
    for each in includes.undeclared():
        first, name, kind = each.uses[0], each.names[0], tag_of(each)
        if includes.bringer(each):
            continue
        is_used = "used" if first.is_type else "included"
        ends = CMAKE_STOPS if includes.required.requires(each) else BUILD_ENDS
        message = (
            f"`{name}` is not declared, and `{first.header}` of it is {is_used}: {ends} where nothing else brings it; "
            f"{advice(declared, kind, *each.names)}"
        )
        places = related((use.path, use.span) for use in each.uses)
        is_mild = is_unmet(declared, name, each.names) or including.are_optional(each) or including.are_idle(each)
        by_hand = includes.by_hand.why(each.cmake, each.names, [use.header for use in each.uses])
        behind = None if includes.required.requires(each) else includes.ros1.stopping_all(use.path for use in each.uses)
        is_mild = is_mild or includes.by_hand.may_be_submodule(each) or bool(by_hand) or behind is not None
        level, end = Severity.INFO if is_mild else None, "" if behind is None else behind.sentence
        yield Hit(first.path, first.span, message + by_hand + end, level, places, declaration(declared, kind, name))
    if not any(missing.bringer for missing in includes.find_packages.missing()):  # else DEP104 reports both
        yield from left_to_others(declared, brought_includes(includes), "included")
