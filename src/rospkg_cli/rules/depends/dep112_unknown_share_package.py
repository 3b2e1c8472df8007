"""DEP112 unknown-share-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.repository.foreign_images import foreign_image
from ...checks.share_lookups import ShareLookups
from ...checks.wrong_lookups import wrong_lookups
from ...example import CMAKE, Example, manifest
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...light_dataclasses import replace
from ...rule import rule

MODULE = """\
from ament_index_python.packages import get_package_share_directory

print(get_package_share_directory('{}'))
"""
SOURCE = """\
#include <ament_index_cpp/get_package_share_directory.hpp>

int main() {{return ament_index_cpp::get_package_share_directory("{}").size();}}
"""
LINES = """\
find_package(ament_index_cpp REQUIRED)
add_executable(talker src/talker.cpp)
target_link_libraries(talker ament_index_cpp::ament_index_cpp)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
"""
CPP = {
    "CMakeLists.txt": CMAKE.replace("ament_package", LINES + "ament_package"),
    "package.xml": manifest("  <depend>ament_index_cpp</depend>\n", "ament_cmake"),
}
NEEDS = {"package.xml": manifest("  <exec_depend>ament_index_python</exec_depend>\n")}


@rule(
    "DEP112",
    "unknown-share-package",
    over=ShareLookups,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "it is in a branch of a function, a condition stands on the way to it, only tests reach "
        "it, it is in a program that nothing starts, while others are started, no target certainly compiles the "
        "file, or an image that the repository builds on may bring it",
        Severity.INFO: "nothing starts or imports the module or leads to the function, or a page alone names it, a "
        "switch turns it off, it stands behind `rclpy.spin`, or code catches that the package is not there",
    },
    examples=(
        Example(
            bad={**NEEDS, "my_pkg/talker.py": MODULE.format("«my_pgk»")},
            good={"my_pkg/talker.py": MODULE.format("my_pkg")},
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={"src/talker.cpp": SOURCE.format("«my_pgk»"), **CPP},
            good={"src/talker.cpp": SOURCE.format("my_pkg")},
            on="ament_cmake",
            fix=Safety.UNSAFE,
        ),
    ),
)
def unknown_share_package(lookups: ShareLookups) -> Iterator[Hit]:
    """
    ## What it does
    Finds Python modules and C++ that look for the share directory or the prefix of a misspelt package.
    Look-ups in Python with more arguments than they take, as where a parenthesis of `os.path.join()` is misplaced, are
    reported, too.

    ## Why is this bad?
    The build is green, and the node ends with PackageNotFoundError or TypeError.

    ## When it is quiet
    Where the name is near none of the workspace, of the dependencies and of the known packages; where a submodule or a
    listed repository that is not here is called like that; where the exception is caught, but for a clear slip of a
    package that is here, which is an info; in files that nothing installs, and under a condition that never holds on
    Linux. In a module that nothing starts or imports, in a function that no program leads to (of C++, that no code
    calls), behind `rclpy.spin`, and under a switch that nothing turns on, be it a parameter that is off by default and
    that nothing in the repository sets, it is an info. Where the repository builds on an image that is none of the
    plain ones (`ros`, `ubuntu`, …), that may bring the package: a warning. Launch files have rules of their own
    (DEP103).

    ## Fix safety
    The intended package is a guess.
    """
    for found in lookups.unknown.found():
        image = foreign_image(lookups.files)
        brought = image.may_bring if image is not None else ""
        harm = "the code goes on without it" if found.is_caught else "this raises PackageNotFoundError"
        message = f"there is no package `{found.name}`: {harm}; did you mean `{found.near}`?"
        level = Severity.INFO if found.is_caught else Severity.WARNING if image is not None else None
        fix = Fix(f"write `{found.near}`", (Edit(found.path, found.span, found.near),), Safety.UNSAFE)
        yield weighed(lookups, Hit(found.path, found.span, message + brought, level, fix=fix))
    for wrong in wrong_lookups(lookups):
        yield weighed(lookups, Hit(wrong.path, wrong.span, f"`{wrong.name}` {wrong.why}: this raises TypeError"))


def weighed(lookups: ShareLookups, hit: Hit) -> Hit:
    """Return a hit with its level, and what is said of a place that seldom runs."""
    if lookups.is_left(hit.path):
        return replace(hit, level=Severity.INFO, message=f"{hit.message}; nothing starts or imports this module")
    if why := lookups.why_seldom(hit.path, hit.span):
        return replace(hit, level=Severity.INFO, message=f"{hit.message}{why}")
    is_certain = lookups.is_run(hit.path) and not lookups.is_conditional(hit.path, hit.span)
    return hit if is_certain or hit.level is Severity.INFO else replace(hit, level=Severity.WARNING)
