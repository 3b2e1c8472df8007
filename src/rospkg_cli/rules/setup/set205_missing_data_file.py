"""SET205 missing-data-file."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.repository.left_to_people import UNTIL_MADE
from ...checks.setup.dead_links import dead_links
from ...checks.setup.share_files import ShareFiles
from ...example import Example, setup_py
from ...finding import Hit, Severity
from ...languages.python.lost_commas import joined_strings
from ...package.setup.data_files import DataEntry, DataFile
from ...rule import rule
from ...suggest import did_you_mean

ENTRY = "        ('share/' + package_name, ['package.xml']),\n"


def config(entry: str) -> str:
    return setup_py().replace(ENTRY, f"{ENTRY}        {entry},\n")


GOOD = config("('share/' + package_name + '/config', ['config/nav.yaml'])")
YAML = {"config/nav.yaml": "/**:\n  ros__parameters:\n    rate: 2.0\n"}
FETCHED = ", until it is fetched, as a page or a script here says"
PATHS = "from pathlib import Path\n"
FOUND = "Path('config').glob('*.yaml')"
SHAPES = {
    "list-entry": "is a list; colcon stops at it: write a tuple `(destination, [files])`",
    "text-sources": "has a string where the list of files belongs; colcon stops at it: write `[…]` around it",
    "tuple-sources": "has a tuple where the list of files belongs; colcon stops at it: write `[…]`",
    "nested-list": "has a list inside of the list of files; colcon stops at it: take one pair of brackets away",
    "path": 'holds a Path, whose `repr` colcon can\'t read: it stops with "malformed node or string"; write `str(…)`',
    "length": "is no pair of a destination and a list of files",
}


@rule(
    "SET205",
    "missing-data-file",
    over=ShareFiles,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "a glob matches a link to nothing: elsewhere there may be what it points to; or a page or a "
        "script says to fetch what is in its folder",
        Severity.INFO: "a page or a script has people fetch, make or copy the file itself, by its name",
    },
    examples=(
        Example(
            bad={**YAML, "setup.py": config("('share/' + package_name + '/config', ['«config/nva.yaml»'])")},
            good={"setup.py": GOOD},
        ),
        Example(
            bad={**YAML, "setup.py": config("('share/' + package_name, ['«config»'])")},
            good={"setup.py": GOOD},
        ),
        Example(
            bad={"setup.py": config("('share/' + package_name + '/config', ['«/home/ada/nav.yaml»'])")},
            good={**YAML, "setup.py": GOOD},
        ),
        Example(
            bad={**YAML, "setup.py": config("«('share/' + package_name + '/config', 'config/nav.yaml')»")},
            good={"setup.py": GOOD},
        ),
        Example(
            bad={**YAML, "setup.py": config("«['share/' + package_name + '/config', ['config/nav.yaml']]»")},
            good={"setup.py": GOOD},
        ),
        Example(
            bad={**YAML, "setup.py": config("«('share/' + package_name + '/config', [['config/nav.yaml']])»")},
            good={"setup.py": GOOD},
        ),
        Example(
            bad={
                **YAML,
                "setup.py": PATHS + config(f"«('share/' + package_name, list({FOUND}))»"),
            },
            good={"setup.py": PATHS + config(f"('share/' + package_name, list(map(str, {FOUND})))")},
        ),
        Example(
            bad={"README.md": "", "NOTICE": "", "setup.py": config("('share/my_pkg', [«'README.md' 'NOTICE'»])")},
            good={"setup.py": config("('share/my_pkg', ['README.md', 'NOTICE'])")},
        ),
    ),
)
def missing_data_file(shared: ShareFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds entries of `data_files` that can't be installed.
    It is a file that does not exist, a link to nothing that a glob matches, a folder, an absolute path, an entry that
    is no tuple of a destination and a list, or a `Path` in place of a string.

    ## Why is this bad?
    The build stops: "can't copy 'config': doesn't exist or not a regular file", "'data_files' must be relative", or a
    bare AssertionError that does not mention setup.py.

    ## When it is quiet
    Where setup.py may write files, where a .gitignore names the file, since a build then writes it, below a submodule
    that is not checked out, and for sources that can't be evaluated. A file whose folder or archive a page or a script
    of the repository fetches or unpacks is missing on a clean machine alone: a warning. It is an info where one
    has people fetch, make or copy the file itself (`map_saver_cli -f maps/lab`), or writes it, by variables or in a
    loop, too.
    """
    for entry in shared.package.setup.data_entries:
        if entry.shape:
            yield Hit(entry.path, entry.span, f"this entry of `data_files` {SHAPES[entry.shape]}")
        for file in entry.files:
            if why := fault(shared, entry, file):
                end, level = (FETCHED, Severity.WARNING) if shared.is_fetched(file) else ("", None)
                end, level = (f", {UNTIL_MADE}", Severity.INFO) if shared.is_made(file) else (end, level)
                yield Hit(file.setup_text.path, file.setup_text.shown, why + end, level)
    for glob, link in dead_links(shared.package):
        message = (
            f"`{glob.pattern}` matches `{link}`, a link to nothing here: the build stops with \"can't copy '{link}'\"; "
            "correct or remove the link"
        )
        yield Hit(shared.package.setup.path, glob.span, message, Severity.WARNING)


def fault(shared: ShareFiles, entry: DataEntry, file: DataFile) -> str:
    """Return what keeps a file from being installed; "" where nothing does."""
    text, package = file.setup_text.text, shared.package
    if file.is_absolute:
        return f"`{text}` is an absolute path: colcon stops, `data_files` must be relative to setup.py"
    if file.source is None or file in shared.markers:
        return ""
    if package.setup.kind(file.source) == "dir":
        return (
            f"`{text}` is a folder: the build stops, `data_files` installs files; list them, or use `glob('{text}/*')`"
        )
    if not shared.is_missing(file):
        return ""
    if parts := joined_strings(package.setup.source.slice(file.setup_text.span)):
        first, second = (f"`{each}`" for each in (parts[0], parts[-1]))
        return f"a comma is missing between {first} and {second}: the build stops with \"can't copy '{text}'\""
    if "*" in text:
        return f"`{text}` is no file: `data_files` supports no wildcards, the build stops; write `glob('{text}')`"
    hint = did_you_mean(file.source, package.files.paths)
    return f"`{text}` does not exist{hint}: the build stops with \"can't copy '{text}'\""
