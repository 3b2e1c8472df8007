"""CMK006 target-name-clash."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.duplicate_targets import DuplicateTarget, duplicate_targets
from ...example import INTERFACES_BODY, INTERFACES_CMAKE, Example, manifest
from ...finding import Hit, Related, Severity
from ...package.cmake.cmake_package import CMakePackage
from ...rule import rule

BEFORE = "ament_export_dependencies"
NODE = (
    "add_executable(«${PROJECT_NAME}» src/node.cpp)\ninstall(TARGETS ${PROJECT_NAME} DESTINATION lib/${PROJECT_NAME})\n"
)
PYTHON = "find_package(ament_cmake_python REQUIRED)\nament_python_install_package(«${PROJECT_NAME}»)\n"
OTHERS = {
    "package.xml": manifest(INTERFACES_BODY, "ament_cmake"),
    "msg/Status.msg": "bool ok\n",
    "srv/SetMode.srv": "string mode\n---\nbool ok\n",
}
BODY = INTERFACES_BODY.replace(
    "  <buildtool", "  <buildtool_depend>ament_cmake_python</buildtool_depend>\n  <buildtool", 1
)


@rule(
    "CMK006",
    "target-name-clash",
    over=CMakePackage,
    severity=Severity.ERROR,
    examples=(
        Example(
            bad={
                **OTHERS,
                "CMakeLists.txt": INTERFACES_CMAKE.replace(BEFORE, NODE + BEFORE),
                "src/node.cpp": "int main() {return 0;}\n",
            },
            good={
                "CMakeLists.txt": INTERFACES_CMAKE.replace(
                    BEFORE,
                    NODE.replace("«${PROJECT_NAME}»", "node").replace("TARGETS ${PROJECT_NAME}", "TARGETS node")
                    + BEFORE,
                )
            },
            on="ament_cmake",
        ),
        Example(
            bad={
                **OTHERS,
                "package.xml": manifest(BODY, "ament_cmake"),
                "CMakeLists.txt": INTERFACES_CMAKE.replace(BEFORE, PYTHON + BEFORE),
                "my_pkg/__init__.py": "",
            },
            good={
                "CMakeLists.txt": INTERFACES_CMAKE.replace(
                    BEFORE, PYTHON.replace("«${PROJECT_NAME}»", "my_pkg_py") + BEFORE
                ),
                "my_pkg/__init__.py": None,
                "my_pkg_py/__init__.py": "",
            },
            on="ament_cmake",
        ),
    ),
)
def target_name_clash(package: CMakePackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds targets that are created twice under one name.
    Mostly it is `rosidl_generate_interfaces(${PROJECT_NAME})` together with an executable, a library or a Python
    package of the project's name.

    ## Why is this bad?
    CMake stops with "cannot create target … because another target with the same name already exists". Interfaces
    belong in a package of their own, which nodes in other packages then depend on.

    ## When it is quiet
    Where one of the two is made under a condition that can't be evaluated, and inside `if(NOT TARGET …)`. Imported
    targets, and interfaces with SKIP_INSTALL next to a Python package, are left alone.
    """
    for clash in duplicate_targets(package.cmake):
        first = Related(clash.first.path, clash.first.span, f"`{clash.first_command}` makes it here")
        yield Hit(clash.second.path, clash.second.span, message(package, clash), related=(first,))


def message(package: CMakePackage, clash: DuplicateTarget) -> str:
    start = f"`{clash.second_command}` makes `{clash.name}`, as `{clash.first_command}` does: CMake stops with "
    stops = f'{start}"another target with the same name already exists"; '
    if "rosidl_generate_interfaces" in (clash.first_command, clash.second_command):
        return f"{stops}rename the other one, or move the interfaces to `{package.facts.name}_interfaces`"
    return f"{stops}rename one of them"
