"""SET303 test-package-installed."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.python_package import PythonPackage
from ...edits.setup_py import exclude_packages
from ...example import SETUP_PY, Example
from ...finding import Fix, Hit, Safety, Severity
from ...rule import rule

FOUND = "find_packages(exclude=['test'])"


@rule(
    "SET303",
    "test-package-installed",
    over=PythonPackage,
    severity=Severity.WARNING,
    examples=(
        Example(
            bad={"setup.py": SETUP_PY.replace(FOUND, "«find_packages()»"), "test/__init__.py": ""},
            good={"setup.py": SETUP_PY},
            fix=Safety.SAFE,
        ),
    ),
)
def test_package_installed(package: PythonPackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds a `find_packages()` that also finds the tests at the top of the package.

    ## Why is this bad?
    They are installed as a top-level module `test`, which hides the one of the standard library, and every package
    that does so overwrites the one before. In an installed workspace only one of them is left.

    ## When it is quiet
    Where the tests are excluded, where `where=` leads elsewhere, and where the folder has no `__init__.py`.
    """
    for search in package.setup.searches:
        tops = [name for name in search.found if name in ("test", "tests")]
        if not tops or search.where:
            continue
        names = [name for name in search.found if name.partition(".")[0] in tops]
        wanted = [*tops, *[f"{top}.*" for top in tops if any(n.startswith(f"{top}.") for n in names)]]
        edits = exclude_packages(package.setup, search, wanted)
        message = (
            f"`find_packages()` also finds `{tops[0]}`, and installs it as a top-level module, where the tests of such "
            f"packages overwrite each other; exclude it"
        )
        fix = Fix(f"exclude {', '.join(wanted)}", edits) if edits else None
        yield Hit(search.path, search.span, message, fix=fix)
