"""SET304 tests-require."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.python_package import PythonPackage
from ...edits.setup_py import move_tests_require
from ...example import Example, setup_py
from ...finding import Fix, Hit, Safety, Severity
from ...rule import rule

NEW = "extras_require={'test': ['pytest']}"
GOOD = setup_py()
GONE = (72, 0)


@rule(
    "SET304",
    "tests-require",
    over=PythonPackage,
    severity=Severity.INFO,
    levels={Severity.WARNING: "a named target has setuptools 72 or later (Lyrical on)"},
    examples=(
        Example(
            bad={"setup.py": GOOD.replace(NEW, "«tests_require»=['pytest']")},
            good={"setup.py": GOOD},
            fix=Safety.SAFE,
        ),
        Example(
            bad={"setup.py": GOOD.replace(NEW, "«tests_require»=['pytest']")},
            good={"setup.py": GOOD},
            targets=("lyrical",),
            fix=Safety.SAFE,
        ),
    ),
)
def tests_require(package: PythonPackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds `tests_require` without `extras_require={'test': …}`.

    ## Why is this bad?
    setuptools 72 removed the option: it is ignored with a warning. colcon reads from it that the tests want pytest;
    without it `colcon test` runs unittest, which finds none of them, and may well be green. `extras_require` works with
    every version since Humble.

    ## When it is quiet
    Where `extras_require` has `test` already, and where `tests_require` is empty or can't be evaluated.
    """
    setup = package.setup
    argument = setup.argument("tests_require")
    if argument is None or setup.has_test_extras or not setup.texts("tests_require"):
        return
    level = Severity.WARNING if package.targets.named(lambda each: each.setuptools >= GONE) else None
    edits = move_tests_require(setup)
    message = (
        "`tests_require` was removed in setuptools 72 (Lyrical has 78): `colcon test` then runs no test; write "
        "`extras_require={'test': ['pytest']}`, which works from Humble on"
    )
    fix = Fix("move it to extras_require={'test': …}", edits) if edits else None
    yield Hit(setup.path, setup.name_span("tests_require"), message, level=level, fix=fix)
