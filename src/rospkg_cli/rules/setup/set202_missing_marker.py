"""SET202 missing-marker."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.share_files import ShareFiles
from ...example import SETUP_PY, Example
from ...finding import Create, Fix, Hit, Safety, Severity
from ...rule import rule

BAD = SETUP_PY.replace("'resource/' + package_name", "«'resource/' + package_name»")


@rule(
    "SET202",
    "missing-marker",
    over=ShareFiles,
    severity=Severity.ERROR,
    examples=(
        Example(
            bad={"setup.py": BAD, "resource/my_pkg": None},
            good={"resource/my_pkg": ""},
            fix=Safety.SAFE,
        ),
    ),
)
def missing_marker(shared: ShareFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds a package whose `data_files` install an ament index marker that does not exist.

    ## Why is this bad?
    The build stops: "can't copy 'resource/my_pkg': doesn't exist or not a regular file". The marker is an empty file.
    git keeps no empty folder, so where `resource/` was committed without it, the next clone lacks it; and a package
    that was renamed still has the old one.

    ## When it is quiet
    Where setup.py may write files, and where the marker has a wrong name that setup.py gives the package (SET401).
    """
    for file in shared.markers:
        if file.source is not None and shared.is_missing(file) and not shared.is_misnamed(file):
            message = (
                f"`{file.source}` does not exist: the build stops with \"can't copy '{file.source}'\"; create it as an "
                f"empty file and commit it"
            )
            fix = Fix(f"create the empty file {file.source}", (Create(file.source, ""),))
            yield Hit(file.setup_text.path, file.setup_text.shown, message, fix=fix)
