"""CMK117 unknown-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.foreign_targets import ForeignTargets
from ...checks.cmake.met_here import by_whom
from ...checks.cmake.mistyped_packages import MistypedPackages
from ...checks.cmake.package_sentences import EXPORT, STOPS, with_doubt
from ...checks.enumeration import in_ticks
from ...example import CMAKE, Example, manifest
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...rule import rule

NEEDS_RCLCPP = manifest("  <depend>rclcpp</depend>\n", "ament_cmake")
LIBRARY = """\
find_package(rclcpp REQUIRED)
add_library(core SHARED src/core.cpp)
target_link_libraries(core PUBLIC rclcpp::rclcpp)
install(TARGETS core EXPORT core_targets DESTINATION lib)
ament_export_targets(core_targets)
ament_export_dependencies({})
"""
SOURCE = "int core() {return 1;}\n"


def cmake(name: str) -> str:
    return CMAKE.replace("ament_package", LIBRARY.format(name) + "ament_package")


def cmake_handed(keyword: str) -> str:
    target = "target_link_libraries(core PUBLIC rclcpp::rclcpp)"
    return cmake("rclcpp").replace(target, f"ament_target_dependencies(core {keyword}rclcpp)")


@rule(
    "CMK117",
    "unknown-package",
    over=MistypedPackages,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "it is the package itself, which may be installed from an earlier build; or a target is "
        "looked for that is linked, and not required; or an image that the repository builds on may bring it",
        Severity.INFO: "it is exported, and no package of the workspace looks for this one; or another package, a "
        "folder outside or a repository that is listed may bring it: it is found in other letters, is not known, or "
        "a package that is not declared, or a short name two letters off, is near",
    },
    examples=(
        Example(
            bad={"CMakeLists.txt": cmake("«rclpcp»"), "package.xml": NEEDS_RCLCPP, "src/core.cpp": SOURCE},
            good={"CMakeLists.txt": cmake("rclcpp")},
            on="ament_cmake",
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={"CMakeLists.txt": cmake_handed("«PRIVATE» "), "package.xml": NEEDS_RCLCPP, "src/core.cpp": SOURCE},
            good={"CMakeLists.txt": cmake_handed("PUBLIC ")},
            on="ament_cmake",
        ),
        Example(
            bad={
                "CMakeLists.txt": CMAKE.replace("find_package(ament_cmake", "find_package(«ament_cmak»"),
            },
            good={"CMakeLists.txt": CMAKE},
            on="ament_cmake",
            fix=Safety.UNSAFE,
        ),
    ),
)
def unknown_package(packages: MistypedPackages) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages that CMake looks for, links or exports and that are one or two letters off.
    Where a target is given a library in other letters than CMake found it by (`pcl` for `PCL`), it reports that, too.
    It reads `find_package(… REQUIRED)`, `ament_target_dependencies()` and `ament_export_dependencies()`. In the last
    two it also finds targets of the package itself, which are no packages, in the last one libraries
    (`${OpenCV_LIBRARIES}`), in both packages that are not known and neither found nor declared, and in the
    first one the package itself and names of targets (`Eigen3::Eigen`), required or not; in the second one keywords
    that it does not take (PRIVATE); in the last two targets of packages (`rclcpp::rclcpp`), which are no packages.

    ## Why is this bad?
    CMake stops: "Could not find a package configuration file", or "the passed package name … was not found before".
    What is exported stops the packages that build against this one.

    ## When it is quiet
    Where a package that is found and not released may find one that a target is given. For names that a package or a
    rosdep key has, that package.xml declares (DEP001 judges these), or that nothing known is near to; nor for those
    that differ from a known one in case alone, unless that is certainly found as `<Name>Config.cmake` (ament's are):
    CMake finds `<name>-config.cmake` by any. Near are only
    packages that CMake finds or package.xml declares; what `find_package()` looks for is compared with those declared
    that are not found otherwise. Under a condition that can't be evaluated. What is exported is an info where no
    package of the workspace looks for this one. So is a name near to another one where a list names repositories that
    are not here, where CMake looks in folders outside of the package (`CMAKE_MODULE_PATH`), or fetches a project of
    that name. What rests on other packages is one, too: unknown names to which none is near, those in other
    letters or with a word less where the right one is not of ament, a name near to a package that package.xml does not
    declare (but for swapped letters), one of less than eight letters that is two letters off, variables that hold no
    packages (`${OpenCV_LIBRARIES}`, maybe empty), and targets that are looked for without REQUIRED and not linked.
    Where the repository builds on an image that is none of the plain ones (`ros`, `ubuntu`, …), that may bring it: a
    warning.

    ## Fix safety
    The nearest name may not be the one that was intended.
    """
    reported = set()
    for each in packages.all():
        reported.add((each.word.path, each.word.span))
        fix = None
        if each.near and packages.package.cmake.source_text(each.word).strip('"') == each.word.text:
            edit = Edit(each.word.path, each.word.span, each.near)
            fix = Fix(f"write `{each.near}`", (edit,), Safety.UNSAFE)
        is_asked = each.kind == "imported" and "REQUIRED" not in each.call.texts
        is_open, is_met = packages.may_be_elsewhere(each), each.call.name != EXPORT or bool(packages.consumers.finders)
        is_sure, brought = is_met and each.is_certain and not is_open, packages.may_be_brought(each)
        level = Severity.WARNING if is_asked or each.kind == "own" or brought else None
        text = by_whom(with_doubt(each, is_open) + (brought if is_sure else ""), is_met)
        yield Hit(each.word.path, each.word.span, text, level if is_sure else Severity.INFO, fix=fix)
    for given in packages.foreign():
        if (given.words[0].path, given.words[0].span) not in reported:
            yield given_targets(packages, given)


def given_targets(packages: MistypedPackages, each: ForeignTargets) -> Hit:
    word, own, facts = each.words[0], each.only_own, packages.package.facts
    others = [name for name in each.packages if name != facts.name]
    are, them = ("are targets", "packages") if each.words[1:] else ("is a target", "package")
    advice = f"name the {'packages' if others[1:] else 'package'} {in_ticks(others)} here" if others else "remove it"
    text = f"{each.names} {are}, and no {them}: {STOPS[each.call.name]}; {advice}"
    fix = None
    name = each.packages[0]
    if own is not None and name in packages.names.found and packages.package.cmake.source_text(own) == own.text:
        fix = Fix(f"write `{name}`", (Edit(own.path, own.span, name),), Safety.UNSAFE)
    is_met = each.call.name != EXPORT or bool(packages.consumers.finders)
    return Hit(word.path, word.span, by_whom(text, is_met), None if is_met else Severity.INFO, fix=fix)
