"""DEP104 undeclared-find-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.undeclared_find_package import FindPackageDependencies, UndeclaredFindPackage
from ...edits.manifest import add_dependency
from ...example import CMAKE, Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...ros.manifest import is_buildtool
from ...rule import rule

FOUND = CMAKE.replace("ament_package()", "find_package(«rclcpp» REQUIRED)\nament_package()")
FOUND_EIGEN = CMAKE.replace("ament_package()", "find_package(«Eigen3» REQUIRED)\nament_package()")
FOUND_IN_TESTS = CMAKE.replace(
    "ament_package()", "if(BUILD_TESTING)\n  find_package(«ament_cmake_gtest» REQUIRED)\nendif()\nament_package()"
)


@rule(
    "DEP104",
    "undeclared-find-package",
    over=FindPackageDependencies,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "where only tests need it, or a declared dependency may bring it",
        Severity.INFO: "where a declared dependency is known to bring it, or package.xml has it in a comment",
    },
    examples=(
        Example(
            on="ament_cmake",
            bad={"CMakeLists.txt": FOUND},
            good={"package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake")},
            fix=Safety.SAFE,
        ),
        Example(
            on="ament_cmake",
            bad={"CMakeLists.txt": FOUND_EIGEN},
            good={"package.xml": manifest("  <depend>eigen</depend>\n", "ament_cmake")},
            fix=Safety.SAFE,
        ),
        Example(
            on="ament_cmake",
            bad={"CMakeLists.txt": FOUND_IN_TESTS},
            good={"package.xml": manifest("  <test_depend>ament_cmake_gtest</test_depend>\n", "ament_cmake")},
            fix=Safety.SAFE,
        ),
    ),
)
def undeclared_find_package(dependencies: FindPackageDependencies) -> Iterator[Hit]:
    """
    ## What it does
    Finds required `find_package()` calls for packages that package.xml does not declare.
    ROS packages are checked, and libraries that have a rosdep key (`Eigen3` is `eigen`). Without REQUIRED the call
    counts where a target or an export uses the package all the same. What is optional or under a condition that depends
    on the machine is left alone, and so is what comes with the build tools.

    ## Why is this bad?
    It builds where the package happens to be installed, or to be built before. On a clean machine and on the build farm
    CMake stops with "Could not find a package configuration file"; in a workspace colcon may build it too early.

    ## References
    - REP-149, depend and buildtool_depend
    """
    for missing in dependencies.missing():
        found, name = missing.found, missing.names[0]
        tests = found.call.testing
        kind = "test_depend" if tests else "buildtool_depend" if is_buildtool(name) else "depend"
        tag = f"<{kind}>{name}</{kind}>"
        known = "" if name == found.name else f" (`{name}` for rosdep)"
        message = (
            f"package.xml does not declare `{found.name}`{known}, which CMake requires: "
            f"{consequence(missing)}; add {tag}"
        )
        level = Severity.WARNING if tests or missing.transitive == "possible" else None
        level = (
            Severity.INFO if missing.transitive == "certain" or name in dependencies.declared.commented_out else level
        )
        fix = Fix(f"add {tag}", (add_dependency(dependencies.declared.manifest, kind, name),))
        yield Hit(found.word.path, found.word.span, message, level, fix=fix)


def consequence(missing: UndeclaredFindPackage) -> str:
    if missing.transitive != "no":
        return "it is there only as long as another dependency brings it"
    stops = f'stops with "Could not find a package configuration file provided by {missing.found.name}"'
    return f"on a clean machine the build {'of the tests ' if missing.found.call.testing else ''}{stops}"
