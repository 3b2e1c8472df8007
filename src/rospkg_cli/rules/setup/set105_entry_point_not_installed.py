"""SET105 entry-point-not-installed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...checks.enumeration import in_ticks
from ...checks.setup.started_entry_points import EntryPointTree
from ...edits.setup_py import add_packages
from ...example import Example, scripts, setup_py
from ...finding import Fix, Hit, Related, Safety, Severity
from ...package.setup.entry_point import EntryPoint
from ...rule import rule

LISTED = setup_py(scripts("talker = «my_pkg.nodes.talker»:main")).replace(
    "find_packages(exclude=['test'])", "[package_name]"
)
FILES = {"my_pkg/nodes/__init__.py": "", "my_pkg/nodes/talker.py": "def main():\n    print('hello')\n"}
GOOD = LISTED.replace("«", "").replace("»", "").replace("[package_name]", "[package_name, 'my_pkg.nodes']")


@rule(
    "SET105",
    "entry-point-not-installed",
    over=EntryPointTree,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "the workspace is built with `--symlink-install`, or nothing here starts the program, though "
        "others of the package are started",
        Severity.INFO: "each command here that builds it has `--symlink-install`",
    },
    examples=(Example(bad={**FILES, "setup.py": LISTED}, good={"setup.py": GOOD}, fix=Safety.UNSAFE),),
)
def entry_point_not_installed(entries: EntryPointTree) -> Iterator[Hit]:
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
    Where a file above the package builds with `--symlink-install`, it is a warning, and an info where all commands that
    pages, scripts and containers build it with do. It is a warning, too, where nothing in the workspace starts or names
    any of the programs, while another one of the package is started.

    ## Fix safety
    The module may belong elsewhere instead.
    """
    tree = entries.tree
    if not tree.package.knows_installed_modules or tree.missing_folders:
        return
    found = tree.not_installed()
    named = [inner for inner in found if inner]
    if named:
        yield hit(entries, named, [each for inner in named for each in found[inner]])
    if "" in found:
        yield hit(entries, (), found[""])


def hit(checked: EntryPointTree, names: Sequence[str], entries: Sequence[tuple[EntryPoint, str]]) -> Hit:
    """Return what is said of entry points whose packages one list leaves out, or whose modules lie in none."""
    (first, path), *others = entries
    tree, left = checked.tree, checked.started.left_all([entry for entry, _ in entries])
    edits = add_packages(tree.setup, *names) if names else ()
    what = f"add {in_ticks(names)} to `packages`" if names else "move it into a package of `packages`"
    who = f"`{first.name}` and {len(others)} more raise" if others else f"`{first.name}` raises"
    link = tree.link_of(*names)
    but = f", but for `--symlink-install` (`{link}`)" if link else ""
    lacking = f"`{path}` is" if len(names) < 2 else f"`{path}` and others are"
    message = f"{lacking} not installed: the build is green, and {who} ModuleNotFoundError{but}; {what}{left}"
    related = tuple(Related(entry.path, entry.module_span, f"`{entry.name}` too") for entry, _ in others)
    fix = Fix(f"add {in_ticks(names)} to `packages`", edits, Safety.UNSAFE) if edits else None
    level = Severity.WARNING if link or left else None
    level = Severity.INFO if link and tree.is_always_linked else level
    return Hit(first.path, first.module_span, message, level, related, fix)
