"""The one launch file that setup.py does not install, where it lists all others of the folder by their names."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...package.setup.data_files import DataFile
from .uninstalled_files import UninstalledFiles

LAUNCH = "launch"
FEW = 2
"""The number of launch files that is too small to show that setup.py installs all of a folder."""
STARTS = "def generate_launch_description("


def left_out(uninstalled: UninstalledFiles) -> Iterator[tuple[str, DataFile]]:
    """Yield the file, with the last one that is listed; not one that a launch file names, which has a finding there."""
    package = uninstalled.package
    if not package.knows_data_files:
        return
    entries = (entry for entry in package.setup.data_entries if entry.glob is None)
    listed = {file.source: file for entry in entries for file in entry.files if file.source}
    places = {posixpath.dirname(path) for path, file in listed.items() if f"/{LAUNCH}/" in file.destination}
    for folder in sorted({LAUNCH, *places}):
        files = launch_files(uninstalled, folder)
        lost = [
            path
            for path in files
            if path not in uninstalled.shared.covered and package.files.readable_text(path).strip()
        ]
        own = [path for path in files if path in listed]
        if len(lost) == 1 and len(files) > FEW and len(own) == len(files) - 1:
            name = posixpath.basename(lost[0])
            if not any(name in package.files.readable_text(path) for path in own):
                yield lost[0], [file for path, file in listed.items() if path in own][-1]


def launch_files(uninstalled: UninstalledFiles, folder: str) -> list[str]:
    """Return the launch files of a folder; for another name than `launch/` only those in Python."""
    if folder == LAUNCH:
        return [path for path in uninstalled.useful(folder) if posixpath.dirname(path) == folder]
    files = uninstalled.package.files
    here = [path for path in files.paths if posixpath.dirname(path) == folder and path.endswith(".py")]
    here = [path for path in here if STARTS in files.readable_text(path)]
    return [path for path in here if not files.absent.is_ignored(path)]
