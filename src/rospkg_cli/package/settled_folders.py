"""Folders of a share directory that are all known, although commands of others may install files elsewhere."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable

from ..files import PackageFiles, ReaderInput
from ..lazy_regex import regex
from .install_table import InstalledFile, InstallTable

INSTALLING = regex(
    r"(?i)install|package|setup|begin|end|auto|export|launch|share|data|config|resource|copy|deploy|add_"
)
"""What a command is called that may well put files into a share directory."""
DESTINATION = regex(r"\b(?:INSTALL\w*|DESTINATION|SHARE)\b|\bshare/")


def settled_folders(reading: ReaderInput) -> frozenset[str]:
    """Return the folders of which all is known, where only commands that name neither them nor a place are not."""
    table = reading.parts(InstallTable).only
    unknown = [each for each in table.unknown if each.what == "share"] if table is not None else []
    if table is None or not unknown or any(not each.command or INSTALLING.search(each.command) for each in unknown):
        return frozenset()
    calls = [reading.files.source(each.path).slice(each.span) for each in unknown]
    if any(DESTINATION.search(call) for call in calls):
        return frozenset()
    whole = {folder for folder in copied_whole(table.rows, reading.files) if folder}
    return frozenset(each for each in whole if not any(posixpath.basename(each) in call for call in calls))


def copied_whole(rows: Iterable[InstalledFile], files: PackageFiles) -> set[str]:
    """Return the folders of the share directory that hold all files of one folder of the package, and no others."""
    sources: dict[str, set[str]] = {}
    for row in rows:
        kind, _, rest = row.destination.partition("/")
        if kind == "share" and not row.maybe:
            sources.setdefault(posixpath.dirname(rest.partition("/")[2]), set()).add(row.source)
    found = set()
    for folder, copied in sources.items():
        origin = {posixpath.dirname(source) for source in copied}
        if len(origin) == 1 and "" not in origin:
            here = {path for path in files.below(*origin) if posixpath.dirname(path) in origin}
            found |= {folder} if here == copied else set()
    return found
