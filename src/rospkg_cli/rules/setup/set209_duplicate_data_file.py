"""SET209 duplicate-data-file."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.share_files import ShareFiles
from ...edits.data_files import remove_source
from ...example import SETUP_PY, Example
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule

LINE = "        ('share/' + package_name, ['package.xml']),\n"
TWICE = SETUP_PY.replace(LINE, f"{LINE}        ('share/' + package_name, ['«package.xml»']),\n")


@rule(
    "SET209",
    "duplicate-data-file",
    over=ShareFiles,
    severity=Severity.WARNING,
    levels={Severity.INFO: "both have one destination"},
    examples=(Example(bad={"setup.py": TWICE}, good={"setup.py": SETUP_PY}, fix=Safety.SAFE),),
)
def duplicate_data_file(shared: ShareFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds files that `data_files` installs twice.
    It is a file that is named twice for one destination, or a marker or a package.xml with two destinations.

    ## Why is this bad?
    colcon keeps one destination for each source, the last one: of a marker that is installed elsewhere too, it says
    that the package "doesn't explicitly install a marker", and adds it once more.

    ## When it is quiet
    Where two globs overlap, which is harmless, and where the same file goes to two folders on purpose: only the
    marker and package.xml must not.
    """
    setup = shared.package.setup
    for file, first in shared.doubles:
        if file.destination == first.destination:
            message = f"`{file.setup_text.text}` is listed twice for `{file.destination}`, to no effect; remove one"
            level, edits = Severity.INFO, remove_source(setup, file)
        else:
            message = (
                f"`{file.setup_text.text}` is installed as `{file.destination}` and as `{first.destination}`: colcon "
                f"keeps only the last place and warns that the other is missing; install it once"
            )
            level, edits = Severity.WARNING, ()
        fix = Fix(f"install {file.setup_text.text} once", edits) if edits else None
        related = (Related(first.setup_text.path, first.setup_text.shown, "the other one"),)
        yield Hit(file.setup_text.path, file.setup_text.shown, message, level, related=related, fix=fix)
