"""DEP122 undeclared-interface-linters."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.interface_linters import ALL, FLAG, NEEDED, InterfaceLinters
from ...edits.undeclared_dependency import declaration
from ...example import INTERFACES_BODY, INTERFACES_CMAKE, Example, manifest
from ...finding import Hit, Safety, Severity
from ...rule import rule

FILE = '  "srv/SetMode.srv"\n'
LINTED = INTERFACES_CMAKE.replace(FILE, f"{FILE}  «ADD_LINTER_TESTS»\n")
TEST = "  <test_depend>ament_lint_common</test_depend>\n"
TESTED = manifest(INTERFACES_BODY.replace("  <member_of", f"{TEST}  <member_of"), "ament_cmake")


@rule(
    "DEP122",
    "undeclared-interface-linters",
    over=InterfaceLinters,
    severity=Severity.INFO,
    examples=(
        Example(
            on="interfaces",
            bad={"CMakeLists.txt": LINTED},
            good={"package.xml": TESTED},
            fix=Safety.SAFE,
        ),
    ),
)
def undeclared_interface_linters(linters: InterfaceLinters) -> Iterator[Hit]:
    """
    ## What it does
    Finds `rosidl_generate_interfaces(… ADD_LINTER_TESTS)` in packages that declare no linters.

    ## Why is this bad?
    The generators of interfaces then run `find_package(ament_cmake_cppcheck REQUIRED)`, and the same of other linters,
    unless tests are switched off. On Humble no generator brings them: after `rosdep install` on a clean machine, and
    in the tests of the build farm, CMake stops. Since Jazzy they come with rosidl_generator_py.

    ## When it is quiet
    Where ament_lint_common or ament_cmake_cppcheck is declared under any tag, where a dependency other than the
    generators brings them or may do so, where CMake finds them itself (DEP104), and where the word may not be given.

    ## References
    - [rosidl_generate_interfaces](https://github.com/ros2/rosidl/blob/rolling/rosidl_cmake/cmake/rosidl_generate_interfaces.cmake)
    """
    for path, span in linters.unmet():
        message = (
            f"`{FLAG}` makes CMake require `{NEEDED}` and other linters, and package.xml declares none: they "
            "come with the generators since Jazzy, and on Humble CMake may stop where tests are built; "
            f"add <test_depend>{ALL}</test_depend>"
        )
        yield Hit(path, span, message, fix=declaration(linters.declared, "test_depend", ALL))
