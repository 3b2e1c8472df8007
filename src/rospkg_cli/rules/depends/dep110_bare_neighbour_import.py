"""DEP110 bare-neighbour-import."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.bare_neighbours import BareNeighbours
from ...checks.depends.own_imports import OwnImports
from ...checks.repository.path_starts import ALONE, is_started_by_path_alone
from ...example import Example, scripts, setup_py
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...rule import rule

FILES = {"setup.py": setup_py(scripts("talker = my_pkg.talker:main")), "my_pkg/speech.py": "GREETING = 'hello'\n"}
MAIN = "\n\ndef main():\n    print(GREETING)\n"


@rule(
    "DEP110",
    "bare-neighbour-import",
    over=OwnImports,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "it is in a function or a branch, which may not be run, or in a program that nothing starts, "
        "while others are started; or an image that the repository builds on, a library that a page has "
        "installed by hand, or the maker of the device that it drives may bring the module",
        Severity.INFO: "nothing leads to the function, or imports a module of the library, it stands behind "
        "`rclpy.spin`, pages and scripts start the file by its path alone, a text puts its folder on PYTHONPATH, or "
        "the package has no program, and no package of the workspace depends on it",
    },
    examples=(
        Example(
            bad={**FILES, "my_pkg/talker.py": f"from «speech» import GREETING\n{MAIN}"},
            good={"my_pkg/talker.py": f"from my_pkg.speech import GREETING\n{MAIN}"},
            fix=Safety.UNSAFE,
        ),
    ),
)
def bare_neighbour_import(imports: OwnImports) -> Iterator[Hit]:
    """
    ## What it does
    Finds imports of a module of the same package, or of a file in the same folder, by its bare name.

    ## Why is this bad?
    It works where the file is started by its path, for Python looks next to it. `ros2 run` starts the entry point, and
    there is "No module named 'speech'".

    ## When it is quiet
    Where something else may provide the name: a dependency, the standard library, a package of the workspace, or pip,
    as a page, a Dockerfile or the requirements say; where the own module lacks what is imported from it or read of it:
    then another library is intended; for optional imports, for scripts installed to `lib/<package>` and modules put
    there or into a folder of it (`data_files`), in modules that no entry point leads to (they may be started by their
    path; in a package without programs, those with a `__main__`), under the `__main__` of an entry point's module, and
    where the package changes `sys.path` or sets PYTHONPATH. A module that imports its own name means another one. Where
    the repository builds on an image that is none of the plain ones (`ros`, `ubuntu`, `python`, …), or a page or script
    has a library of that name installed by hand (a wheel, `setup.py install`, `cp … site-packages`), that may bring a
    module of the name: a warning, for it fails on a clean machine. So is a module that drives a device (it imports
    `smbus`, `RPi` and the like), which the maker of a robot may have put there as a library. Where pages and scripts
    have Python start the file by its path, and none runs or launches the package by `ros2`, it is an info, and where a
    page, a script, a container or a launch file puts the folder on PYTHONPATH.

    ## Fix safety
    A file that is also started by its path needs its package installed from then on.
    """
    is_offered = imports.reached.is_library and not imports.workspace.needing(imports.facts.name)
    doing = "the import" if imports.reached.is_library else "`ros2 run`"
    neighbours = BareNeighbours(imports)
    for found in neighbours.all():
        file, each, full = found.file, found.each, found.full
        is_installed = full in imports.installed.sources
        message = (
            f"`{each.module}` is a module of this package, and no top-level one: {doing} "
            f"ends with ModuleNotFoundError; write `{full}`{'' if is_installed else ', which nothing installs yet'}"
        )
        fix = None
        if is_installed and each.names and file.source.slice(each.span) == each.module:
            fix = Fix(f"write `{full}`", (Edit(file.path, each.span, full),), Safety.UNSAFE)
        why, brought = imports.places.why_seldom(file.path, each.span), neighbours.may_be_brought(found)
        if not why and is_started_by_path_alone(imports.files, imports.facts.name, file.path):
            why, fix = ALONE, None
        if not why:
            from ...checks.repository.python_path_settings import ON_PATH, is_on_python_path  # what few packages need

            why, fix = (ON_PATH, None) if is_on_python_path(imports.files, file.path) else (why, fix)
        is_mild = brought or each.is_local or imports.places.is_conditional(file.path, each.span)
        level = Severity.INFO if why or is_offered else Severity.WARNING if is_mild else None
        yield Hit(file.path, each.span, f"{message}{why or brought}", level, fix=fix)
