"""SET301 missing-init."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.module_tree import ModuleTree
from ...example import Example
from ...finding import Create, Fix, Hit, Safety, Severity
from ...rule import rule
from ...source import Span

FILES = {"my_pkg/talker.py": "from my_pkg.speech.words import GREETING\n\nprint(GREETING)\n"}


@rule(
    "SET301",
    "missing-init",
    over=ModuleTree,
    severity=Severity.ERROR,
    levels={Severity.WARNING: "nothing in the package imports it"},
    examples=(
        Example(
            bad={**FILES, "my_pkg/speech/words.py": "«»GREETING = 'hello'\n"},
            good={"my_pkg/speech/__init__.py": "", "my_pkg/speech/words.py": "GREETING = 'hello'\n"},
            fix=Safety.SAFE,
        ),
    ),
)
def missing_init(tree: ModuleTree) -> Iterator[Hit]:
    """
    ## What it does
    Finds folders of Python modules without an `__init__.py` that `find_packages()` leaves out.
    They are inside a package that it finds.

    ## Why is this bad?
    `find_packages()` leaves them out: the build is green, and at run time there is "No module named 'my_pkg.speech'".
    In the source folder, and with `--symlink-install`, it works, so the error is found late.
    """
    for folder in tree.missing_inits:
        inside = [path for path in tree.package.files.below(folder) if path.endswith(".py")]
        imported = tree.imports_from(folder)
        name = tree.dotted(folder)
        if name in {said.text for said in tree.setup.packages}:
            imported, what = False, "setuptools says so at each build, and find_packages() would pass it over"
        else:
            what = f"it is not installed, and importing `{name}` raises ModuleNotFoundError"
        message = f"`{folder}/` has no `__init__.py`: {what}; create an empty one"
        fix = Fix(f"create {folder}/__init__.py", (Create(f"{folder}/__init__.py", ""),))
        yield Hit(inside[0], Span(0, 0), message, level=None if imported else Severity.WARNING, fix=fix)
