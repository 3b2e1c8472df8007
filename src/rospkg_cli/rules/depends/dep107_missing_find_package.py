"""DEP107 missing-find-package."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...checks.depends.find_package_uses import MissingFindPackage
from ...checks.depends.found_for_tests import FoundForTests, found_for_tests
from ...checks.depends.included_packages import IncludedPackage
from ...checks.depends.missing_find_package import MissingFindPackages
from ...checks.depends.unfound_libraries import unfound_libraries
from ...checks.enumeration import in_ticks
from ...edits.cmake_find import add_find_package_among
from ...edits.manifest import add_dependency
from ...example import CMAKE, Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule

DECLARED = manifest("  <depend>geometry_msgs</depend>\n", "ament_cmake")
FOUND = "find_package(ament_cmake REQUIRED)\n"
NODE = CMAKE.replace(
    "ament_package()",
    "add_executable(node src/node.cpp)\n"
    "target_link_libraries(node «geometry_msgs::geometry_msgs»)\n"
    "install(TARGETS node DESTINATION lib/${PROJECT_NAME})\nament_package()",
)
GOOD = NODE.replace("«", "").replace("»", "").replace(FOUND, FOUND + "find_package(geometry_msgs REQUIRED)\n")


@rule(
    "DEP107",
    "missing-find-package",
    over=MissingFindPackages,
    severity=Severity.WARNING,
    levels={Severity.INFO: "where another package that is found may bring it"},
    examples=(
        Example(
            on="ament_cmake",
            bad={"package.xml": DECLARED, "CMakeLists.txt": NODE, "src/node.cpp": "int main() {return 0;}\n"},
            good={"CMakeLists.txt": GOOD},
            fix=Safety.UNSAFE,
        ),
        Example(
            on="ament_cmake",
            bad={"CMakeLists.txt": NODE, "src/node.cpp": "int main() {return 0;}\n"},
            good={"package.xml": DECLARED, "CMakeLists.txt": GOOD},
            fix=Safety.UNSAFE,
        ),
    ),
)
def missing_find_package(missing: MissingFindPackages) -> Iterator[Hit]:
    """
    ## What it does
    Finds ROS packages that CMake uses without a `find_package()`.
    Targets are linked with the package or interfaces depend on it, whether it is declared or not, or headers of a
    declared one are included. What is found for tests alone counts as not found where a target of the package itself is
    linked with it. Everything is left alone where a command such as `ament_auto_find_build_dependencies()` finds what
    is declared. Of libraries with a folder of headers of their own (Eigen, OpenCV, PCL), declared ones that no CMake
    file names are reported in such packages, too.

    ## Why is this bad?
    CMake stops ("was not found before", "target … was not found"), or the compiler does not see the headers; it builds
    only as long as another package happens to find this one.

    ## When it is quiet
    What certainly comes with a package that is found is one info where it is declared and included, or where a target
    is linked with it and package.xml does not declare it either; where that is not known, it is an info too.
    Nothing is said where a command such as `ament_auto_find_build_dependencies()` finds what is declared, where a part
    of CMake can't be evaluated, or where something is found that may be the same under another name.

    ## Fix safety
    The call is added after the other `find_package()` calls. A target may have to be linked with the package as well.
    """
    cmake, found = missing.includes.cmake, list(missing.packages())
    brought = [each for each in found if each.may_be_transitive]
    if brought[1:]:
        yield in_one(brought)
    if libraries := list(unfound_libraries(missing.includes)):
        yield not_found(libraries)
    if included := list(missing.brought()):
        yield found_by_others(included)
    yield from map(only_for_tests, found_for_tests(missing.includes))
    for each in found if not brought[1:] else (each for each in found if each not in brought):
        line = f"find_package({each.name} REQUIRED)"
        ends = "it builds only while another package brings it" if each.may_be_transitive else "the build stops"
        tag = "test_depend" if each.testing else "depend"
        lines = f"`{line}`" if each.is_declared else f"`{line}`, and <{tag}>{each.name}</{tag}> to package.xml"
        message = f"CMake never looks for `{each.name}`, but {each.usage}: {ends}; add {lines}"
        edits = add_find_package_among(cmake, each.name, testing=each.testing)
        if edits and not each.is_declared:
            edits = (*edits, add_dependency(missing.declared.manifest, tag, each.name))
        fix = Fix(f"add {line}", edits, Safety.UNSAFE) if edits else None
        yield Hit(each.path, each.span, message, Severity.INFO if each.may_be_transitive else None, fix=fix)


def found_by_others(included: Sequence[MissingFindPackage]) -> Hit:
    """Return one info for all that is declared and included, and comes with what CMake looks for."""
    first, *others = included
    names = in_ticks([each.name for each in included])
    message = (
        f"{names} {'are' if others else 'is'} declared and included, and CMake never looks for "
        f"{'them' if others else 'it'}: other packages bring {'them' if others else 'it'} today; find what you use"
    )
    related = tuple(Related(each.path, each.span, each.usage) for each in others)
    return Hit(first.path, first.span, message, Severity.INFO, related)


def only_for_tests(each: FoundForTests) -> Hit:
    name, word = each.found.name, each.link.word
    stops = "it builds only while another package finds it" if each.may_be_brought else "the build stops"
    message = (
        f"CMake looks for `{name}` for tests alone, but `{each.link.target}` is linked with it: without BUILD_TESTING "
        f"{stops}; move `find_package({name} REQUIRED)` out of the block"
    )
    related = (Related(each.found.word.path, each.found.word.span, "it is found here"),)
    return Hit(word.path, word.span, message, Severity.INFO if each.may_be_brought else None, related)


def in_one(brought: Sequence[MissingFindPackage]) -> Hit:
    """Return one info for all that is used and that other packages bring."""
    first, *others = brought
    names, lacking = in_ticks([each.name for each in brought]), [e.name for e in brought if not e.is_declared]
    lacks = f", and package.xml lacks {in_ticks(lacking)}" if lacking else ""
    todo = "find and declare them" if lacking else "find them"
    ends = f"it builds only while other packages bring them; {todo}"
    message = f"CMake never looks for {names}{lacks}, but uses them: {ends}"
    related = tuple(Related(each.path, each.span, f"`{each.name}`: {each.usage}") for each in others)
    return Hit(first.path, first.span, message, Severity.INFO, related)


def not_found(libraries: Sequence[IncludedPackage]) -> Hit:
    """Return one info for all libraries that are declared and included, and that another package finds."""
    first, names = libraries[0].uses[0], [each.cmake for each in libraries]
    message = (
        f"CMake never looks for {in_ticks(names)}, but `{first.header}` is included here: it builds only while another "
        f"package brings the folder of headers; add {in_ticks(f'find_package({name} REQUIRED)' for name in names)}"
    )
    others = (each.uses[0] for each in libraries[1:])
    related = tuple(Related(use.path, use.span, f"`{use.header}` is included here") for use in others)
    return Hit(first.path, first.span, message, Severity.INFO, related)
