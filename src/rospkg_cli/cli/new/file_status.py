"""What became of each file, a line for each: created, identical, conflict, skipped."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from ...control_characters import visible
from ...light_dataclasses import dataclass
from ...report.color import paint
from ...scaffold.answers_record import RECORD
from ...scaffold.existing_folder import FolderDifference
from ...scaffold.lacking_lines import lacking_lines
from ...scaffold.render import RenderedFile
from ...tree import TreeEntry

COLORS = {"created": "green", "updated": "green", "merged": "green", "conflict": "red", "replaced": "yellow",
          "skipped": "yellow", "removed": "yellow"}  # fmt: skip

SHOWN = 6
"""Lines that one file lacks; --diff shows all of them."""


@dataclass(frozen=True)
class FileStatus:
    status: str
    path: str
    about: str = ""
    lacks: Sequence[str] = ()
    """Lines that would be written there, and that the file does not have."""


def status_lines(files: Iterable[FileStatus], color: bool) -> Iterator[str]:
    for file in files:
        status = paint(f"{file.status:<9}", COLORS.get(file.status, "dim"), color)
        yield f"{status}  {visible(file.path)}{f'   {file.about}' if file.about else ''}"
        for line in file.lacks[:SHOWN]:
            yield f"{'':9}    {paint(visible(line), 'dim', color)}"
        if len(file.lacks) > SHOWN:
            yield f"{'':9}    and {len(file.lacks) - SHOWN} more: --diff shows them"


def folder_status(there: FolderDifference, existing: str) -> list[FileStatus]:
    """Return what becomes of each file, by path; `existing` is `force`, `skip`, or "" where neither was asked for."""
    found = [FileStatus("created", file.path) for file in there.missing]
    found += [FileStatus("identical", file.path) for file in there.same]
    found += [other(file, before, existing) for file, before in there.other]
    return sorted(found, key=lambda each: each.path)


def other(file: RenderedFile, before: TreeEntry, existing: str) -> FileStatus:
    """Return the status of a file that differs from what would be written."""
    if existing == "force":
        return FileStatus("replaced", file.path)
    status = "skipped" if existing else "conflict"
    if file.path == RECORD:
        return FileStatus(status, file.path, "holds other answers; `rospkg new --update` merges")
    lacks = lacking_lines(before, file.entry)
    if lacks is None:
        return FileStatus(status, file.path, "differs, and is no text")
    return FileStatus(status, file.path, "differs, and lacks:" if lacks else "differs, and lacks no line", lacks)
