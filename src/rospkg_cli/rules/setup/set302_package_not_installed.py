"""SET302 package-not-installed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...checks.enumeration import in_ticks
from ...checks.setup.lost_modules import LostModules
from ...edits.setup_py import add_packages
from ...example import SETUP_PY, Example, scripts, setup_py
from ...finding import Fix, Hit, Safety, Severity
from ...package.setup.setup_py import SetupPy
from ...rule import rule

FILES = {
    "my_pkg/talker.py": "from my_pkg.speech.words import GREETING\n\n\ndef main():\n    print(GREETING)\n",
    "my_pkg/speech/__init__.py": "",
    "my_pkg/speech/words.py": "GREETING = 'hello'\n",
}
FOUND = "find_packages(exclude=['test'])"
STARTED = setup_py(scripts("talker = my_pkg.talker:main"))
NONE = SETUP_PY.replace(f"    packages={FOUND},\n", "").replace("import find_packages, setup", "import setup")

ORDER = (None, Severity.WARNING, Severity.INFO)


@rule(
    "SET302",
    "package-not-installed",
    over=LostModules,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "no entry point imports it as it starts, the workspace is built with `--symlink-install`, or "
        "a newer setuptools finds it; or the pages name no distribution after Humble, and nothing imports it",
        Severity.INFO: "nothing that an entry point leads to imports it, and no package depends on this one or nothing "
        "in the repository imports it at all",
    },
    examples=(
        Example(
            bad={**FILES, "setup.py": STARTED.replace(FOUND, "«[package_name]»")},
            good={"setup.py": STARTED.replace(FOUND, "[package_name, 'my_pkg.speech']")},
            fix=Safety.SAFE,
        ),
        Example(
            bad={"setup.py": SETUP_PY.replace(FOUND, "[package_name, '«my_pkg.speech»']")},
            good={"setup.py": SETUP_PY.replace(FOUND, "[package_name]")},
        ),
        Example(
            bad={"my_pkg/talker.py": "RATE = 10.0\n", "setup.py": NONE.replace("setup(", "«setup»(")},
            good={"setup.py": SETUP_PY},
        ),
    ),
)
def package_not_installed(lost: LostModules) -> Iterator[Hit]:
    """
    ## What it does
    Finds Python packages that `packages=[…]` leaves out, and listed ones that do not exist.
    Packages below a listed one are checked, and whether `packages` is there at all.

    ## Why is this bad?
    `packages=[package_name]` holds that one package, none of those below it: the build is green and at run time there
    is "No module named 'my_pkg.speech'". Of a listed folder that is not there, setuptools says "package directory …
    does not exist" and stops. Without `packages`, setuptools before 61 (Humble) installs no module, and newer ones stop
    at `resource/`, which they take for a second package ("Multiple top-level packages discovered").

    ## When it is quiet
    Where `packages` can't be evaluated or is found by `find_packages()`, where setup.py may write files, in folders of
    tests, where git ignores the folder, and below a submodule that is not checked out. With `--symlink-install` Python
    imports from the source folder: where a README, a Dockerfile or another file of the repository builds that way, a
    package that is left out is a warning. It is one, too, where no entry point imports it as it starts, as a function
    does, or where nothing starts those that do, and another program of the package is started. It is an info where
    nothing imports it to which an entry point leads, and no package of the workspace depends on this one or no code of
    the repository imports it at all, where a text puts the source folder on PYTHONPATH or has pip install it (`pip
    install -e .`), or an import is tried and has something in its place. Where `py_modules` installs all modules of it
    that are imported, nothing is said. Without `packages` it is a warning where the pages, scripts and workflows of the
    repository name Humble or older ones alone, install no newer setuptools by pip, and nothing imports the package.
    """
    tree, setup = lost.tree, lost.tree.setup
    if not tree.package.knows_installed_modules or setup.searches:
        return
    for said in tree.missing_folders:
        own = tree.package.name
        is_meant = setup.kind(setup.folder_of(own)) == "dir" and own not in setup.package_names
        todo = f"did you mean `{own}`?" if is_meant else "list packages that are there"
        message = f"there is no folder `{setup.folder_of(said.text)}`: setuptools stops; {todo}"
        yield Hit(said.path, said.shown, message)
    if tree.has_unnamed_package:
        yield without_packages(lost)
    unlisted = tree.unlisted if setup.argument("packages") else ()
    levels = {name: level_of(lost, name) for name in unlisted}
    for level, why in sorted(set(levels.values()), key=lambda each: (ORDER.index(each[0]), each[1])):
        names = [name for name in unlisted if levels[name] == (level, why)]
        link = tree.link_of(*names)
        yield left_out(setup, names, level or (Severity.WARNING if link else None), f" (`{link}`)" if link else "", why)


def without_packages(lost: LostModules) -> Hit:
    """Return what is wrong with a setup() that names no packages at all."""
    tree, own = lost.tree, lost.tree.package.name
    has_resource, is_old = tree.setup.kind("resource") == "dir", lost.programs.has_old_setuptools
    is_met = has_resource and (not is_old or tree.names.is_imported_elsewhere(tree.setup.folder_of(own)))
    ends = f"a newer setuptools stops, and one before 61 installs nothing of `{own}`"
    if not has_resource or is_old:
        ends = f"setuptools before 61 installs nothing of `{own}`{', and a newer one stops' if has_resource else ''}"
    message = f"setup() has no `packages`: {ends}; add `packages=find_packages()`"
    return Hit(tree.setup.path, tree.setup.span, message, level=None if is_met else Severity.WARNING)


def level_of(lost: LostModules, name: str) -> tuple[Severity | None, str]:
    """Return the level of a Python package that is left out: None where an entry point can't start without it."""
    tree = lost.tree
    if tree.started.reaches(name):
        if why := lost.why_found(name):
            return Severity.INFO, why
        left = lost.left(name)
        return Severity.WARNING if left else None, left
    folder = tree.setup.folder_of(name)
    is_used = tree.started.may_reach(name) and tree.names.imports_from(folder)
    is_met = is_used or tree.may_be_for_others(folder)
    why = lost.why_found(name) if is_met else ""
    return Severity.WARNING if is_met and not why else Severity.INFO, why


def left_out(setup: SetupPy, names: Sequence[str], level: Severity | None, linking: str, why: str) -> Hit:
    """Return what is wrong with a list that leaves some packages out."""
    are, them = ("are", "them") if len(names) > 1 else ("is", "it")
    but = f", but for `--symlink-install`{linking}" if linking else ""
    message = (
        f"{in_ticks(names)} {are} not in `packages`: the build is green, and importing {them} raises "
        f"ModuleNotFoundError{but}; add {them}, or use `find_packages(exclude=['test'])`{why}"
    )
    edits = add_packages(setup, *names)
    fix = Fix(f"add {in_ticks(names)} to `packages`", edits) if edits else None
    return Hit(setup.path, setup.value_span("packages"), message, level=level, fix=fix)
