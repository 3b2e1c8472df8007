"""SET104 duplicate-entry-point."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.python_package import PythonPackage
from ...example import Example, scripts, setup_py
from ...finding import Hit, Related, Severity
from ...package.setup.entry_points import EntryPoint
from ...rule import rule

MODULE = "def main():\n    print('hello')\n"
MODULES = {"my_pkg/talker.py": MODULE, "my_pkg/listener.py": MODULE}


@rule(
    "SET104",
    "duplicate-entry-point",
    over=PythonPackage,
    severity=Severity.ERROR,
    examples=(
        Example(
            bad={
                **MODULES,
                "setup.py": setup_py(scripts("talker = my_pkg.talker:main", "«talker» = my_pkg.listener:main")),
            },
            good={"setup.py": setup_py(scripts("talker = my_pkg.talker:main", "listener = my_pkg.listener:main"))},
        ),
    ),
)
def duplicate_entry_point(package: PythonPackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds two entry points of one group with the same name.

    ## Why is this bad?
    setuptools from 60 on stops with "'distutils.core.setup()' was never called". The older one of Humble makes one
    executable of the two, and does not say which.

    ## When it is quiet
    Where an entry is made by code that can't be evaluated. One name in two groups is no duplicate.
    """
    seen: dict[tuple[str, str], EntryPoint] = {}
    for entry in package.setup.entry_points:
        if not entry.name or entry.fault:
            continue
        first = seen.setdefault((entry.group, entry.name), entry)
        if first is not entry:
            message = f"`{entry.name}` is twice in `{entry.group}`: setuptools stops, Humble's keeps one; rename one"
            related = (Related(first.path, first.name_span, "the other one"),)
            yield Hit(entry.path, entry.name_span, message, related=related)
