"""SET101 entry-point-module-missing."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.missing_modules import MissingModules
from ...checks.setup.python_package import PythonPackage
from ...checks.setup.started_entry_points import StartedEntryPoints
from ...example import SETUP_PY, Example, scripts, setup_py
from ...finding import Hit, Severity
from ...package.setup.entry_point import EntryPoint
from ...rule import rule

MODULE = "def main():\n    print('hello')\n"
MADE = "; a page or a script here fetches or writes it"
PLUGIN = "entry_points={'ros2cli.verb': ['show = «my_pkg.shwo»:ShowVerb']},"


@rule(
    "SET101",
    "entry-point-module-missing",
    over=StartedEntryPoints,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "nothing here starts the program, though others of the package are started",
        Severity.INFO: "a page or a script fetches or writes the module, or a comment says that it is still to come",
    },
    examples=(
        Example(
            bad={"setup.py": setup_py(scripts("talker = «my_pkg.taker»:main")), "my_pkg/talker.py": MODULE},
            good={"setup.py": setup_py(scripts("talker = my_pkg.talker:main"))},
        ),
        Example(
            bad={"setup.py": setup_py(scripts("talker = «talker»:main")), "my_pkg/talker.py": MODULE},
            good={"setup.py": setup_py(scripts("talker = my_pkg.talker:main"))},
        ),
        Example(
            bad={"setup.py": setup_py(PLUGIN), "my_pkg/show.py": "class ShowVerb: ...\n"},
            good={"setup.py": SETUP_PY, "my_pkg/show.py": None},
        ),
    ),
)
def entry_point_module_missing(started: StartedEntryPoints) -> Iterator[Hit]:
    """
    ## What it does
    Finds entry points, of executables and of plugins, whose module does not exist.
    Modules of other packages, compiled modules and modules that setup.py generates are left alone.

    ## Why is this bad?
    The build does not look: it is green, and `ros2 run` raises ModuleNotFoundError.

    ## When it is quiet
    Where setup.py may write files or generates the module, for compiled modules, templates and links, for modules of
    other packages, where a .gitignore names the file, and below a submodule that is not checked out. It is a warning
    where nothing in the workspace starts or names the program, while another one of the package is started, by a launch
    file, a page, a script, a workflow or code with `ros2 run`. The word alone does not name it where another package or
    a program of one is called so, nor behind a slash, where it is a topic or a folder, nor on a page alone where launch
    files have the start of this program in a comment, or the page says that it is not finished or not ported yet. It is
    an info where a page or a script fetches or writes the module by its name, where a comment says that it is not there
    yet, and in a folder of a course whose page has people copy its files into a package of `ros2 pkg create`.
    """
    package, missing = started.package, MissingModules(started.package)
    for entry in package.setup.entry_points:
        if not entry.module or entry.fault or not missing.has(entry.module):
            continue
        near = missing.suggestion(entry.module)
        hint = f"; did you mean `{near}`?" if near else ""
        left = started.left(entry)
        made = not near and is_made(package, entry)
        message = f"there is no module `{entry.module}`: {consequence(package, entry)}{hint}{MADE if made else left}"
        level = Severity.INFO if made else Severity.WARNING if left else None
        yield Hit(entry.path, entry.module_span, message, level)


def is_made(package: PythonPackage, entry: EntryPoint) -> bool:
    """Return whether a command of a page or a script fetches or writes the file of a module, by its name."""
    from ...checks.repository.pages_and_scripts import FetchedFiles  # imported for findings alone

    return FetchedFiles(package.files).has_by_command(f"{entry.module.replace('.', '/')}.py")


def consequence(package: PythonPackage, entry: EntryPoint) -> str:
    if not entry.is_script:
        return f"the build is green, and loading `{entry.name}` ({entry.group}) raises ModuleNotFoundError"
    return f"the build is green, and `ros2 run {package.name} {entry.name}` raises ModuleNotFoundError"
