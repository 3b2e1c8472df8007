"""DEP102 undeclared-test-import."""

from __future__ import annotations

from collections.abc import Iterator

from ...edits.manifest import add_dependency
from ...example import Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...model.uses.imported import Imported
from ...rule import rule


@rule(
    "DEP102",
    "undeclared-test-import",
    over=Imported,
    severity=Severity.WARNING,
    examples=(
        Example(
            bad={"test/test_viewer.py": "import «pytest»\n\n\ndef test_nothing():\n    pytest.skip()\n"},
            good={"package.xml": manifest("  <test_depend>python3-pytest</test_depend>\n")},
            fix=Safety.SAFE,
        ),
    ),
)
def undeclared_test_import(imported: Imported) -> Iterator[Hit]:
    """
    ## What it does
    Finds imports in the files of `test/` and `tests/` that package.xml does not declare: ROS packages, and Python
    libraries that have a rosdep key. Any tag will do; what only tests use belongs in test_depend.

    ## Why is this bad?
    `colcon test` passes on the machine where the module happens to be installed and fails on a clean one: rosdep and
    the build farm install what package.xml names.

    ## References
    - REP-149, test_depend
    """
    manifest = imported.declared.manifest
    for missing in imported.missing_in_tests():
        first, *others = missing.places
        tag = f"<test_depend>{missing.name}</test_depend>"
        brings = ", ".join(f"`{name}`" for name in missing.brings)
        message = (
            f"package.xml does not declare `{missing.name}`, which this test imports as `{first.module}`: on a clean "
            f"machine rosdep does not install it and `colcon test` fails with ModuleNotFoundError; add {tag}"
            + (f", which brings {brings} as well" if brings else "")
        )
        fix = Fix(f"add {tag}", (add_dependency(manifest, "test_depend", missing.name),))
        related = tuple(Related(place.path, place.span, "and here") for place in others[:3])
        yield Hit(first.path, first.span, message, related=related, fix=fix)
