"""The scripts above a package, in the folders that lead to it and in folders of scripts there (`start_robot.sh`)."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...files import PackageFiles
from ...tree import READABLE

ENDINGS = (".sh", ".bash", ".service", ".desktop")


def scripts_above(files: PackageFiles) -> Iterator[str]:
    """Yield what scripts of any name say; only asked of what is a finding, as all files of the run are looked at."""
    if files.whole is None:
        return
    there, parts = files.whole.files(), files.folder.split("/") if files.folder else []
    above = {"/".join(parts[:depth]) for depth in range(len(parts))}
    whole = PackageFiles(files.whole)
    for path, kind in there.items():
        if kind in READABLE and path.endswith(ENDINGS):
            folder = posixpath.dirname(path)
            is_beside = posixpath.dirname(folder) in above and f"{folder}/package.xml" not in there
            if folder in above or (folder and is_beside):
                yield whole.readable_text(path)
