"""The one launch file that setup.py does not install, where it lists all others of the folder by their names."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...package.setup.data_files import DataFile
from .share_files import ShareFiles

LAUNCH = "launch"
FEW = 2
"""Launch files that don't show what is done with a third one."""


STARTS = "def generate_launch_description("


def left_out(shared: ShareFiles) -> Iterator[tuple[str, DataFile]]:
    """Yield the file, with the last one that is listed; what a launch file names is told there."""
    package = shared.package
    if not package.knows_data_files:
        return
    entries = (entry for entry in package.setup.data_entries if entry.glob is None)
    listed = {file.source: file for entry in entries for file in entry.files if file.source}
    places = {posixpath.dirname(path) for path, file in listed.items() if f"/{LAUNCH}/" in file.destination}
    for folder in sorted({LAUNCH, *places}):
        files = launch_files(shared, folder)
        lost = [path for path in files if path not in shared.covered and package.files.readable_text(path).strip()]
        own = [path for path in files if path in listed]
        if len(lost) == 1 and len(files) > FEW and len(own) == len(files) - 1:
            name = posixpath.basename(lost[0])
            if not any(name in package.files.readable_text(path) for path in own):
                yield lost[0], [file for path, file in listed.items() if path in own][-1]


def launch_files(shared: ShareFiles, folder: str) -> list[str]:
    """Return the launch files of a folder; of one with another name those in Python that describe a launch."""
    if folder == LAUNCH:
        return [path for path in shared.useful(folder) if posixpath.dirname(path) == folder]
    files = shared.package.files
    here = [path for path in files.paths if posixpath.dirname(path) == folder and path.endswith(".py")]
    here = [path for path in here if STARTS in files.readable_text(path)]
    return [path for path in here if not files.absent.is_ignored(path)]
