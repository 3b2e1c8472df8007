"""SET103 malformed-entry-point."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.module_contents import ModuleContents
from ...checks.setup.started_entry_points import StartedEntryPoints
from ...edits.entry_points import repair_entry_point
from ...example import Example, scripts, setup_py
from ...finding import Fix, Hit, Safety, Severity
from ...package.setup.entry_point import EntryPoint
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
AT_START = ("no-attribute", "file-name")
"""What the build takes, and starting the program does not."""


def one(entry: str) -> dict[str, str]:
    return {**MODULES, "setup.py": setup_py(scripts(f"«{entry}»", "listener = my_pkg.listener:main"))}


@rule(
    "SET103",
    "malformed-entry-point",
    over=StartedEntryPoints,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "it names a module that starts what it does when it is imported, or it fails at start, and "
        "nothing here starts it, though others of the package are started"
    },
    examples=(
        Example(bad={**MODULES, "setup.py": setup_py(JOINED)}, good={"setup.py": GOOD}, fix=Safety.UNSAFE),
        Example(bad=one("talker = my_pkg.talker.main"), good={"setup.py": GOOD}, fix=Safety.UNSAFE),
        Example(bad=one("talker = my_pkg.talker.py:main"), good={"setup.py": GOOD}, fix=Safety.UNSAFE),
        Example(bad=one("talker: my_pkg.talker:main"), good={"setup.py": GOOD}),
        Example(bad=one("talker = my_pkg/talker:main"), good={"setup.py": GOOD}, fix=Safety.UNSAFE),
    ),
)
def malformed_entry_point(started: StartedEntryPoints) -> Iterator[Hit]:
    """
    ## What it does
    Finds entry points that are not `name = module:function`.
    There is no `=`, no `:`, a file's name or path instead of a module, or two strings that Python joined because the
    comma between them is missing.

    ## Why is this bad?
    setuptools from 60 on stops with "'distutils.core.setup()' was never called", and does not say where. The older one
    of Humble builds, and makes an executable that can't be started, or one with a wrong name.

    ## When it is quiet
    Where the entry is made by code that can't be evaluated. Where only who starts the program fails, it is a warning if
    nothing in the workspace starts or names it, while another one of the package is started.

    ## Fix safety
    The intended entry point is a guess.
    """
    package, contents = started.package, ModuleContents(started.package)
    for entry in package.setup.entry_points:
        if entry.fault:
            runs = entry.fault == "no-attribute" and contents.runs_when_imported(entry.module)
            end = (
                "it runs because importing the module starts it, and ends with TypeError"
                if runs
                else consequence(entry)
            )
            left = started.left(entry) if not runs and entry.fault in AT_START else ""
            message = f"`{entry.text}` {WHY[entry.fault]}: {end}; write `name = module:function`{left}"
            level = Severity.WARNING if runs or left else None
            edits = repair_entry_point(package.setup, entry)
            fix = Fix("write it as `name = module:function`", edits, Safety.UNSAFE) if edits else None
            span = entry.setup_text.span if entry.fault == "joined" else entry.span
            yield Hit(entry.path, span, message, level, fix=fix)


def consequence(entry: EntryPoint) -> str:
    if entry.fault in AT_START:
        return "the build is green, and the executable fails when it is started"
    return "setuptools stops, and does not name the place"
