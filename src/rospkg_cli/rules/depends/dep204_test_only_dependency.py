"""DEP204 test-only-dependency."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.test_only import TestOnlyDependencies
from ...edits.manifest import change_tag
from ...example import CMAKE, Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...rule import Profile, rule

USED = "  <exec_depend>rclpy</exec_depend>\n"
FOUND = CMAKE.replace(
    "ament_package()", "if(BUILD_TESTING)\n  find_package(std_msgs REQUIRED)\nendif()\nament_package()"
)


@rule(
    "DEP204",
    "test-only-dependency",
    over=TestOnlyDependencies,
    severity=Severity.INFO,
    profile=Profile.PEDANTIC,
    examples=(
        Example(
            bad={
                "package.xml": manifest("  <exec_depend>«python3-pytest»</exec_depend>\n" + USED),
                "my_pkg/talker.py": "import rclpy\n",
                "test/test_talker.py": "import pytest\n\n\ndef test_nothing():\n    pytest.skip()\n",
            },
            good={"package.xml": manifest("  <test_depend>python3-pytest</test_depend>\n" + USED)},
            fix=Safety.UNSAFE,
        ),
        Example(
            on="ament_cmake",
            bad={"package.xml": manifest("  <depend>«std_msgs»</depend>\n", "ament_cmake"), "CMakeLists.txt": FOUND},
            good={"package.xml": manifest("  <test_depend>std_msgs</test_depend>\n", "ament_cmake")},
            fix=Safety.UNSAFE,
        ),
    ),
)
def test_only_dependency(used: TestOnlyDependencies) -> Iterator[Hit]:
    """
    ## What it does
    Finds dependencies that only tests use and that are declared for building or running.
    Only tests import the package, or CMake looks for it only where it builds tests, and it is declared as `<depend>`,
    `<build_depend>` or `<exec_depend>`.

    ## Why is this bad?
    All users of the package install it too, and builds without tests wait for it.

    ## When it is quiet
    Whatever else may use the package keeps the finding back: an import or an include outside of tests, a word in a
    launch or parameter file or in a document, a CMake command outside of tests. An `<exec_depend>` of a CMake package
    is only judged where it is a tool for tests.

    ## Fix safety
    Something outside of the package may rely on the dependency being installed.
    """
    manifest = used.unused.declared.manifest
    for each in used.dependencies():
        line = f"<test_depend>{each.name}</test_depend>"
        message = (
            f"`{each.name}` is declared as <{each.tag}>, and only tests use it: all users install it; write {line}"
        )
        fix = Fix(
            f"declare `{each.name}` as <test_depend>", (change_tag(manifest, each, "test_depend"),), Safety.UNSAFE
        )
        yield Hit(manifest.path, each.span, message, fix=fix)
