"""SET309 lost-comma."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import SETUP_PY, Example
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...languages.python.lost_commas import joined_strings, lost_commas
from ...languages.python.place_kinds import is_in_function
from ...lazy_regex import regex
from ...package.setup.setup_py import SetupPy
from ...rule import rule
from ...source import Span

MARKER = "('share/ament_index/resource_index/packages', ['resource/' + package_name])"
ENTRY = "('share/' + package_name, ['package.xml'])"
GOOD = SETUP_PY
BAD = SETUP_PY.replace(f"{MARKER},\n        {ENTRY}", f"«{MARKER}\n        {ENTRY}»")

NAME = regex(r"[A-Za-z][\w./-]*(?:[<>=~!]=?[\w.*]+)?")
UNFULFILLED = "no distribution has this name, and pip stops at it, though colcon does not"
LISTS: dict[str, tuple[Severity, str]] = {
    "packages": (Severity.ERROR, "the build stops, there is no such folder"),
    "py_modules": (Severity.ERROR, "the build is green, and installs neither"),
    "scripts": (Severity.ERROR, "the build stops, there is no such file"),
    "install_requires": (Severity.INFO, UNFULFILLED),
}
"""The arguments of setup() that are lists of names, and what a wrong one does."""


@rule(
    "SET309",
    "lost-comma",
    over=SetupPy,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "it is in a function, which may not be called",
        Severity.INFO: "it is in `install_requires`, which colcon does not read",
    },
    examples=(
        Example(bad={"setup.py": BAD}, good={"setup.py": GOOD}, fix=Safety.UNSAFE),
        Example(
            bad={"setup.py": GOOD.replace("['setuptools']", "[«'setuptools' 'pyserial'»]")},
            good={"setup.py": GOOD.replace("['setuptools']", "['setuptools', 'pyserial']")},
        ),
    ),
)
def lost_comma(setup: SetupPy) -> Iterator[Hit]:
    """
    ## What it does
    Finds two items in setup.py without a comma between them, or with a dot in its place.
    Of two tuples Python calls the first one, of two strings it makes one. Those of entry points are SET103's, those of
    `data_files` SET205's.

    ## Why is this bad?
    The build stops with a TypeError such as "'tuple' object is not callable", which does not mention the comma.

    ## When it is quiet
    Where the first item is a name or a call: what it stands for may be callable. Where one of two strings is no whole
    name, or there is a file of the joined name.

    ## Fix safety
    More than the comma may be missing.
    """
    for lost in lost_commas(setup.file):
        level = Severity.WARNING if is_in_function(setup.file, lost.span) else None
        start = setup.source.position(lost.position)[0]
        message = f'a comma is missing behind line {start}: setup.py stops with "{lost.exception}: {lost.error}"'
        edit = Edit(setup.path, Span(lost.position, lost.position + lost.instead), ",")
        yield Hit(setup.path, lost.span, message, level, fix=Fix("add the comma", (edit,), Safety.UNSAFE))
    yield from joined_items(setup)


def joined_items(setup: SetupPy) -> Iterator[Hit]:
    """Yield the items of lists of names that Python joined from two strings."""
    for argument, (level, end) in LISTS.items():
        for said in setup.texts(argument):
            parts = joined_strings(setup.source.slice(said.span)) if said.path == setup.path else []
            if parts and all(NAME.fullmatch(part) for part in parts) and setup.kind(said.text) is None:
                message = f"Python joins these strings to `{said.text}`, since there is no comma between them: {end}"
                yield Hit(setup.path, said.span, message, level)
