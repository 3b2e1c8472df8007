"""DEP104 undeclared-find-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.find_package_sentences import not_installable, unknown_command
from ...checks.depends.name_source import is_unmet
from ...checks.depends.own_places import ELSEWHERE
from ...checks.depends.required_by_cmake import stops_with
from ...checks.depends.strange_packages import StrangePackages
from ...checks.depends.undeclared_find_package import UndeclaredFindPackage
from ...checks.depends.undeclared_includes import IncludeDependencies
from ...checks.depends.undeclared_test_commands import CommandsForTests
from ...edits.brought_hits import BroughtUse, brought_includes, left_to_others
from ...edits.undeclared_dependency import advice, declaration, where_absent
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Safety, Severity
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
    over=IncludeDependencies,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "for a package that is found, since it may be installed, and for commands in tests; an "
        "error is a command that nothing defines",
        Severity.INFO: "where a declared dependency brings or may bring it, an unreleased repository declares it in "
        "another package or installs it by apt, package.xml has it in a comment or for older distributions alone, a "
        "page says to install it by hand, CMake looks into a folder of its own, its key has no rule for a supported "
        "distribution, it needs this package itself, or it is unknown here",
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
def undeclared_find_package(includes: IncludeDependencies) -> Iterator[Hit]:
    """
    ## What it does
    Finds required `find_package()` calls for packages that package.xml does not declare.
    ROS packages are checked, and libraries that have a rosdep key (`Eigen3` is `eigen`). Without REQUIRED the call
    counts where a target, an export or a command for tests needs the package all the same. A command for tests
    (`ament_add_gtest()`) counts where its package is neither found nor declared. An unknown name counts where it ends
    like one of interfaces (`acme_msgs`), where `ament_target_dependencies()` is handed it or a target is linked with it
    (`acme_sdk`), or where a package or key is called alike (`GDAL`, `libgdal-dev`). The key of a library without its
    headers (`libboost-thread`) does not serve.

    ## Why is this bad?
    It builds where the package happens to be installed, or to be built before. On a clean machine and on the build farm
    CMake stops with "Could not find a package configuration file", or for a module of its own "Could NOT find Boost";
    in a workspace colcon may build it too early.

    ## When it is quiet
    What a declared dependency certainly installs, or may, as anything may come with a package that is not here, is one
    info, with what only C++ includes of the kind (DEP105). So is a library that a page says to install by hand, or that
    CMake links from /usr/local or /opt, or that CMake looks for in a folder that is named here (`HINTS`,
    `set(OpenCV_DIR …)`, CMAKE_PREFIX_PATH, a Find module that names folders of the package), what another package of
    the repository declares, or a list or a script of it installs (apt alone), where nothing shows a release, and a key
    of rosdep that no supported distribution has a rule for, as vendor packages took the place of `gz-math7`. What is
    optional (QUIET, without use) or under a condition that depends on the machine is left alone, and so is what comes
    with the build tools. A package here that needs this one itself is an info, for to declare it would make a circle;
    where it declares this one, nothing is said.

    ## Fix safety
    The fix is unsafe where no released package has the name, or a comment of package.xml leaves it out.

    ## References
    - REP-149, depend and buildtool_depend
    """
    dependencies, declared = includes.find_packages, includes.declared
    brought: list[BroughtUse] = []
    for missing in dependencies.missing():
        found, name = missing.found, missing.names[0]
        kind = "test_depend" if found.call.testing else "buildtool_depend" if is_buildtool(name) else "depend"
        if missing.bringer:
            brought.append(BroughtUse(name, missing.bringer, kind, found.word.path, found.word.span))
            continue
        if not missing.is_installable:
            yield Hit(found.word.path, found.word.span, not_installable(missing), Severity.INFO)
            continue
        yield undeclared(includes, missing, kind)
    included = brought_includes(includes) if brought else []
    how = "required by CMake or included" if included else "required by CMake"
    yield from left_to_others(declared, [*brought, *included], how)
    for strange in StrangePackages(includes).all():
        level = Severity.WARNING if strange.is_slip else Severity.INFO
        yield Hit(strange.found.word.path, strange.found.word.span, strange.sentence, level)
    for each in CommandsForTests(declared, dependencies.cmake).undeclared():
        level = Severity.WARNING if each.call.testing else Severity.ERROR
        level = Severity.INFO if each.may_be_brought else level
        yield Hit(each.call.path, each.call.command.name_span, unknown_command(each), level)


def undeclared(includes: IncludeDependencies, missing: UndeclaredFindPackage, kind: str) -> Hit:
    """Return the hit of a package that CMake requires and nothing brings."""
    found, name, declared = missing.found, missing.names[0], includes.declared
    known = "" if name == found.name else f" (`{name}` for rosdep)"
    library = includes.find_packages.for_run_time(found)
    what = f"declares `{library}` alone, which has no headers" if library else "does not declare it"
    aside = includes.by_hand.why(found.name, missing.names)
    aside = aside or (ELSEWHERE if includes.find_packages.is_elsewhere(found, missing.names) else "")
    message = (
        f"CMake requires `{found.name}`{known}, and package.xml {what}: "
        f"{consequence(includes, missing)}; {advice(declared, kind, *missing.names)}{aside}"
    )
    level = Severity.INFO if aside or is_unmet(declared, name, missing.names) else Severity.WARNING
    return Hit(found.word.path, found.word.span, message, level, fix=declaration(declared, kind, name))


def consequence(includes: IncludeDependencies, missing: UndeclaredFindPackage) -> str:
    what = "the build of the tests" if missing.found.call.testing else "the build"
    where = where_absent(includes.declared, *missing.names, built=True)
    return f"{where} {what} stops {stops_with(missing.found, includes.find_packages.cmake)}"
