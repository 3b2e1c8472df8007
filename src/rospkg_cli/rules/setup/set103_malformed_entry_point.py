"""SET103 malformed-entry-point."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.python_package import PythonPackage
from ...edits.entry_points import repair_entry_point
from ...example import Example, scripts, setup_py
from ...finding import Fix, Hit, Safety, Severity
from ...package.setup.entry_points import EntryPoint
from ...rule import rule

MODULE = "def main():\n    print('hello')\n"
MODULES = {"my_pkg/talker.py": MODULE, "my_pkg/listener.py": MODULE}
GOOD = setup_py(scripts("talker = my_pkg.talker:main", "listener = my_pkg.listener:main"))
JOINED = """\
entry_points={
        'console_scripts': [
            «'talker = my_pkg.talker:main'
            'listener = my_pkg.listener:main'»,
        ],
    },"""
WHY = {
    "no-equals": "has no `=`",
    "no-attribute": "names no function",
    "joined": "is two entry points without a comma between them",
    "file-name": "names a file",
    "unreadable": "can't be read",
}


def one(entry: str) -> dict[str, str]:
    return {**MODULES, "setup.py": setup_py(scripts(f"«{entry}»", "listener = my_pkg.listener:main"))}


@rule(
    "SET103",
    "malformed-entry-point",
    over=PythonPackage,
    severity=Severity.ERROR,
    levels={Severity.WARNING: "it names a module that starts what it does when it is imported"},
    examples=(
        Example(bad={**MODULES, "setup.py": setup_py(JOINED)}, good={"setup.py": GOOD}, fix=Safety.UNSAFE),
        Example(bad=one("talker = my_pkg.talker.main"), good={"setup.py": GOOD}, fix=Safety.UNSAFE),
        Example(bad=one("talker = my_pkg.talker.py:main"), good={"setup.py": GOOD}, fix=Safety.UNSAFE),
        Example(bad=one("talker: my_pkg.talker:main"), good={"setup.py": GOOD}),
        Example(bad=one("talker = my_pkg/talker:main"), good={"setup.py": GOOD}, fix=Safety.UNSAFE),
    ),
)
def malformed_entry_point(package: PythonPackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds entry points that are not `name = module:function`.
    There is no `=`, no `:`, a file's name or path instead of a module, or two strings that Python joined because the
    comma between them is missing.

    ## Why is this bad?
    setuptools from 60 on stops with "'distutils.core.setup()' was never called", and does not say where. The older one
    of Humble builds, and makes an executable that can't be started, or one with a wrong name.

    ## When it is quiet
    Where the entry is made by code that can't be evaluated.

    ## Fix safety
    The intended entry point is a guess.
    """
    for entry in package.setup.entry_points:
        if entry.fault:
            runs = entry.fault == "no-attribute" and package.runs_when_imported(entry.module)
            end = (
                "it runs because importing the module starts it, and ends with TypeError"
                if runs
                else consequence(entry)
            )
            message = f"`{entry.text}` {WHY[entry.fault]}: {end}; write `name = module:function`"
            level = Severity.WARNING if runs else None
            edits = repair_entry_point(package.setup, entry)
            fix = Fix("write it as `name = module:function`", edits, Safety.UNSAFE) if edits else None
            span = entry.setup_text.span if entry.fault == "joined" else entry.span
            yield Hit(entry.path, span, message, level, fix=fix)


def consequence(entry: EntryPoint) -> str:
    if entry.fault in ("no-attribute", "file-name"):
        return "the build is green, and the executable fails when it is started"
    return "setuptools stops, and does not name the place"
