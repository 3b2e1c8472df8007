"""SET301 missing-init."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.lost_modules import LostModules
from ...checks.setup.module_tree import ModuleTree
from ...checks.setup.stand_alone_scripts import are_scripts
from ...edits.setup_py import add_packages
from ...example import Example, scripts, setup_py
from ...finding import Create, Edit, Fix, Hit, Move, Safety, Severity
from ...lazy_regex import regex
from ...package.file_role import role_of
from ...rule import rule
from ...source import Span

FILES = {
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    "my_pkg/talker.py": "from my_pkg.speech.words import GREETING\n\n\ndef main():\n    print(GREETING)\n",
}

MISSPELT = regex(r"/_{0,3}init_{0,3}\.py$")

SHOWN = regex(r"(?:.*/)?(?:examples?|demos?|scripts?|tools?|tutorials?|notebooks?)")
"""Folders that hold what is read or run, not imported."""


@rule(
    "SET301",
    "missing-init",
    over=LostModules,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "no entry point imports it as it starts, or the workspace is built with `--symlink-install`",
        Severity.INFO: "nothing that an entry point leads to imports it, and no package depends on this one or nothing "
        "in the repository imports it at all, or it is called `old` or holds scripts",
    },
    examples=(
        Example(
            bad={**FILES, "my_pkg/speech/words.py": "«»GREETING = 'hello'\n"},
            good={"my_pkg/speech/__init__.py": "", "my_pkg/speech/words.py": "GREETING = 'hello'\n"},
            fix=Safety.SAFE,
        ),
    ),
)
def missing_init(lost: LostModules) -> Iterator[Hit]:
    """
    ## What it does
    Finds folders of Python modules without an `__init__.py` that `find_packages()` leaves out.
    They are inside a package that it finds.

    ## Why is this bad?
    `find_packages()` leaves them out: the build is green, and at run time there is "No module named 'my_pkg.speech'".
    In the source folder, and with `--symlink-install`, it works, so the error is found late: where a README, a
    Dockerfile or another file of the repository builds that way, it is a warning. It is one, too, where no entry point
    imports the folder as it starts, as a function does, or nothing starts those that do, and another program is. It is
    an info for a folder that nothing imports to which an entry point leads, where no package of the workspace depends
    on this one or no code of the repository imports it at all, the folder is called `deprecated`, `legacy`, `old` or
    `backup`, or each of its files has a shebang line or a `__main__`. It is one, too, where a text puts the source
    folder on PYTHONPATH or has pip install it (`pip install -e .`), or where an import is tried and has something in
    its place.

    ## When it is quiet
    With `find_namespace_packages()`, in folders of launch files that nothing imports, in folders of tests and below
    them, where setup.py generates the folder's modules, and where git ignores the `__init__.py`. What only tests import
    is an info: pytest runs them in the source. So is one that `packages` lists (`my_pkg.speech`, or `my_pkg/speech`):
    setuptools installs it.

    ## Fix safety
    It is unsafe for a folder of examples, scripts or tools that nothing imports: it would be installed with the rest.
    """
    tree = lost.tree
    for folder in tree.missing_inits:
        inside = [path for path in tree.package.files.below(folder) if path.endswith(".py")]
        if all(role_of(path) == "test" for path in inside) or tree.holds_launch_files(folder):
            continue
        name = tree.names.dotted(folder)
        link = tree.link_of(name)
        is_listed = name in tree.setup.package_names
        imported = tree.names.imports_from(folder) and not is_listed
        if is_listed:
            what = "setuptools says so at each build, and find_packages() would pass it over"
        else:
            what = f"it is not installed, and importing `{name}` raises ModuleNotFoundError"
            what += f", but for `--symlink-install` (`{link}`)" if link else ""
        safety = Safety.UNSAFE if not imported and SHOWN.fullmatch(folder) else Safety.SAFE
        start = f"`{folder}/` has no `__init__.py`: {what}"
        init, wrong = f"{folder}/__init__.py", next((path for path in inside if MISSPELT.search(path)), None)
        if wrong is not None:
            message, fix = f"{start}; rename `{wrong}`", Fix(f"rename {wrong} to __init__.py", (Move(wrong, init),))
        else:
            listing, also = listed_too(tree, name)
            message = f"{start}; create an empty one{also}"
            fix = Fix(f"create {init}{also}", (Create(init, ""), *listing), safety)
        level, why = level_of(lost, folder, inside)
        yield Hit(inside[0], Span(0, 0), f"{message}{why}", level, fix=fix)


def level_of(lost: LostModules, folder: str, inside: list[str]) -> tuple[Severity | None, str]:
    """Return the level of a folder that is not installed, None where a program stops, and why it is lower."""
    tree, name = lost.tree, lost.tree.names.dotted(folder)
    is_listed = name in tree.setup.package_names
    imported = tree.names.imports_from(folder) and not is_listed
    is_unused = is_listed or tree.is_set_aside(folder) or are_scripts(inside, tree.package.files)
    may_matter = imported and tree.started.may_reach(name)
    if not may_matter and (is_unused or not tree.may_be_for_others(folder)):
        return Severity.INFO, ""
    if why := lost.why_found(name):
        return Severity.INFO, why
    is_fatal = imported and tree.started.reaches(name) and not tree.link_of(name)
    left = lost.left(name) if is_fatal else ""
    return None if is_fatal and not left else Severity.WARNING, left


def listed_too(tree: ModuleTree, name: str) -> tuple[tuple[Edit, ...], str]:
    """Return how a package gets into a `packages` that is a list, and the words for it."""
    if tree.setup.searches or name in tree.setup.package_names or not tree.setup.argument("packages"):
        return (), ""
    return add_packages(tree.setup, name), f", and list `{name}` in `packages`"
