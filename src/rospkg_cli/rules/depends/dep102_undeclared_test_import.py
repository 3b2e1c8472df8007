"""DEP102 undeclared-test-import."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.undeclared_imports import ImportDependencies, UndeclaredImport
from ...edits.manifest import add_dependency
from ...example import Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule


@rule(
    "DEP102",
    "undeclared-test-import",
    over=ImportDependencies,
    severity=Severity.WARNING,
    levels={Severity.INFO: "where a test tool that is declared brings it, or package.xml has it in a comment"},
    examples=(
        Example(
            bad={"test/test_viewer.py": "import «pytest»\n\n\ndef test_nothing():\n    pytest.skip()\n"},
            good={"package.xml": manifest("  <test_depend>python3-pytest</test_depend>\n")},
            fix=Safety.SAFE,
        ),
    ),
)
def undeclared_test_import(imports: ImportDependencies) -> Iterator[Hit]:
    """
    ## What it does
    Finds imports in `test/` and `tests/` that package.xml does not declare.
    ROS packages are checked, and Python libraries that have a rosdep key. Any tag will do; what only tests use belongs
    in test_depend.

    ## Why is this bad?
    `colcon test` passes on the machine where the module happens to be installed and fails on a clean one: rosdep and
    the build farm install what package.xml names.

    ## References
    - REP-149, test_depend
    """
    for missing in imports.missing_in_tests():
        first, *others = missing.places
        tag = f"<test_depend>{missing.name}</test_depend>"
        message = (
            f"package.xml does not declare `{missing.name}`, which this test imports as `{first.module}`: "
            f"{consequence(missing)}; add {tag}"
        )
        brings = ", ".join(f"`{name}`" for name in missing.also_provides)
        message += f", which brings {brings} as well" if brings else ""
        fix = Fix(f"add {tag}", (add_dependency(imports.declared.manifest, "test_depend", missing.name),))
        related = tuple(Related(place.path, place.span, "and here") for place in others[:3])
        mild = missing.provided_by or missing.name in imports.declared.commented_out
        yield Hit(first.path, first.span, message, Severity.INFO if mild else None, related, fix)


def consequence(missing: UndeclaredImport) -> str:
    if missing.provided_by:
        return "it is there only as long as another dependency brings it"
    return "on a clean machine rosdep does not install it and `colcon test` fails with ModuleNotFoundError"
