"""CMK107 unguarded-test."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.unguarded_tests import UnguardedTest, UnguardedTests
from ...edits.cmake_commands import guard
from ...example import CMAKE, Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule

BODY = "  <test_depend>ament_lint_auto</test_depend>\n  <test_depend>ament_lint_common</test_depend>\n"
CHANGES = """\
Changelog for package my_pkg
============================

1.0.0 (2026-01-02)
------------------
* Drive.
"""
LINES = "find_package(ament_lint_auto REQUIRED)\nament_lint_auto_find_test_dependencies()\n"
MARKED = LINES.replace("find_package(ament_lint_auto REQUIRED)", "«find_package(ament_lint_auto REQUIRED)»")
GUARDED = (
    "if(BUILD_TESTING)\n  find_package(ament_lint_auto REQUIRED)\n  ament_lint_auto_find_test_dependencies()\nendif()\n"
)


@rule(
    "CMK107",
    "unguarded-test",
    over=UnguardedTests,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "where what is looked for is declared or comes with ros_core, and nothing shows that anybody "
        "builds without tests"
    },
    examples=(
        Example(
            bad={
                "CHANGELOG.rst": CHANGES,
                "CMakeLists.txt": CMAKE.replace("ament_package", MARKED + "ament_package"),
                "package.xml": manifest(BODY, "ament_cmake"),
            },
            good={"CMakeLists.txt": CMAKE.replace("ament_package", GUARDED + "ament_package")},
            on="ament_cmake",
            fix=Safety.UNSAFE,
        ),
    ),
)
def unguarded_test(tests: UnguardedTests) -> Iterator[Hit]:
    """
    ## What it does
    Finds test frameworks, linters and tests outside of `if(BUILD_TESTING)` in CMakeLists.txt.
    So does what is said there of targets that are made inside alone. All of a package are one finding.

    ## Why is this bad?
    Where packages are built for release, tests are off and their dependencies are not there: "Could not find a package
    configuration file provided by "ament_lint_auto"".

    ## When it is quiet
    Where the package is more than a `<test_depend>`, and so there without tests too. Inside a condition that can't be
    evaluated, for tests in functions of the package, and in a package that is only for tests.
    `rosdep install` installs test dependencies, and colcon builds tests unless an option says otherwise. It is a
    warning where the repository is visibly released (bloom's files, a job for it, or a CHANGELOG.rst of this name among
    packages that all have one), where a page, a script or a workflow installs only some tags or sets
    `BUILD_TESTING=OFF`, and where a package that is looked for is neither declared nor a part of ros_core, as
    ament_lint_auto is; an info elsewhere.

    ## Fix safety
    Neighbouring commands that are only for tests are put into one `if(BUILD_TESTING)`; what they set is then no longer
    there for the rest of the file when tests are off.
    """
    package = tests.package
    found = list(tests.all()) if package.is_ament else []
    if not found:
        return
    first, *others = found
    guards = guard(package.cmake.root, [each.call.command for each in found])
    edits = tuple(dict.fromkeys(edit for each in found for edit in guards.get(id(each.call.command), ())))
    fix = Fix("put it into `if(BUILD_TESTING)`", edits, Safety.UNSAFE) if edits else None
    related = tuple(Related(each.call.path, each.call.command.span, "and this") for each in others)
    level = None if tests.are_met(found) else Severity.INFO
    yield Hit(first.call.path, first.call.command.span, message(first), level, related, fix)


def message(each: UnguardedTest) -> str:
    verb = f"`find_package({each.what})`" if each.call.name == "find_package" else f"`{each.what}`"
    return (
        f"{verb} is for tests and outside of `if(BUILD_TESTING)`: a build without tests, as for a release, lacks it "
        "and stops; put it inside"
    )
