"""The one launch file that setup.py does not install, where it lists all others of the folder by their names."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...package.setup.data_files import DataFile
from .share_files import ShareFiles

LAUNCH = "launch"
FEW = 2
"""Launch files that don't show what is done with a third one."""


def left_out(shared: ShareFiles) -> Iterator[tuple[str, DataFile]]:
    """Yield the file, with the last one that is listed; what a launch file names is told there."""
    package = shared.package
    paths = shared.useful(LAUNCH) if package.knows_data_files else ()
    files = [path for path in paths if posixpath.dirname(path) == LAUNCH]
    entries = (entry for entry in package.setup.data_entries if entry.glob is None)
    listed = {file.source: file for entry in entries for file in entry.files if file.source in files}
    lost = [path for path in files if path not in shared.covered]
    if len(lost) == 1 and len(files) > FEW and len(listed) == len(files) - 1:
        name = posixpath.basename(lost[0])
        if not any(name in package.files.readable_text(path) for path in listed if path):
            yield lost[0], list(listed.values())[-1]
