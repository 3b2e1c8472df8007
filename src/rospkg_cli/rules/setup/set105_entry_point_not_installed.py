"""SET105 entry-point-not-installed."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.module_tree import ModuleTree
from ...edits.setup_py import add_packages
from ...example import Example, scripts, setup_py
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule

LISTED = setup_py(scripts("talker = «my_pkg.nodes.talker»:main")).replace(
    "find_packages(exclude=['test'])", "[package_name]"
)
FILES = {"my_pkg/nodes/__init__.py": "", "my_pkg/nodes/talker.py": "def main():\n    print('hello')\n"}
GOOD = LISTED.replace("«", "").replace("»", "").replace("[package_name]", "[package_name, 'my_pkg.nodes']")


@rule(
    "SET105",
    "entry-point-not-installed",
    over=ModuleTree,
    severity=Severity.ERROR,
    examples=(Example(bad={**FILES, "setup.py": LISTED}, good={"setup.py": GOOD}, fix=Safety.UNSAFE),),
)
def entry_point_not_installed(tree: ModuleTree) -> Iterator[Hit]:
    """
    ## What it does
    Finds entry points whose module exists and is not installed.
    It is in a Python package that `packages=` (or `py_modules=`) leaves out.

    ## Why is this bad?
    The build is green, and `ros2 run` raises ModuleNotFoundError: what is not in `packages` is not copied. A list
    `packages=[package_name]` holds only the top-level package, none of those below it.

    ## When it is quiet
    Where `packages`, `py_modules` or `package_dir` can't be evaluated, where setup.py may write files, and where a
    folder lacks its `__init__.py` (SET301). A package that is listed and not there stops the build first (SET302).

    ## Fix safety
    The module may belong elsewhere instead.
    """
    if not tree.package.knows_installed_modules or tree.missing_folders:
        return
    for inner, entries in tree.not_installed().items():
        (first, path), *others = entries
        edits = add_packages(tree.setup, inner) if inner else ()
        what = f"add `{inner}` to `packages`" if inner else "move it into a package of `packages`"
        who = f"`{first.name}` and {len(others)} more raise" if others else f"`{first.name}` raises"
        message = f"`{path}` is not installed: the build is green, and {who} ModuleNotFoundError; {what}"
        related = tuple(Related(entry.path, entry.module_span, f"`{entry.name}` too") for entry, _ in others)
        fix = Fix(f"add `{inner}` to `packages`", edits, Safety.UNSAFE) if edits else None
        yield Hit(first.path, first.module_span, message, related=related, fix=fix)
