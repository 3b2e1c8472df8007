"""Paths of which a part is known only when launch runs, and that no file fits: `maps/….yaml` (LCH003)."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Collection, Iterator

from ...files import PackageFiles
from ...package.launch.file_references import FileReference
from ...package.launch.joined_path import OPEN
from ...package.package_facts import PackageFacts

ANYTHING = "x"
"""Takes the place of the unknown part where a function needs a whole path."""
MARKS = "_-."


def fits_nothing(named: FileReference, facts: PackageFacts, files: PackageFiles, *, own: bool) -> bool:
    """Return whether the folder of a path has files, and none of them fits it, whatever its unknown part is."""
    sample = named.path.replace(OPEN, ANYTHING)
    if not named.has_slash or not facts.knows("share_files") or facts.may_write(sample):
        return False
    expected = files.absent if own else files.absent_in(facts.folder)
    known = [*facts.share_files, *facts.uninstalled, *facts.run_time_files, *(files.paths if own else ())]
    if expected.is_ignored(sample) or (own and expected.is_expected(sample)):
        return False
    is_there = any(pattern_of(posixpath.dirname(named.path)).fullmatch(posixpath.dirname(each)) for each in known)
    return is_there and not any(pattern_of(named.path).fullmatch(each) for each in known)


def pattern_of(path: str) -> re.Pattern[str]:
    return re.compile(".*".join(map(re.escape, path.split(OPEN))))


def closest_to_known_part(path: str, known: Collection[str]) -> str | None:
    """Return a path with the only name in its folder that ends as its known end does; None for none or several.

    For `maps/…_map.yaml`, where `maps` has `map.yaml` alone, that is `maps/map.yaml`.
    """
    folder, name = posixpath.split(path)
    end = name.rpartition(OPEN)[2].lstrip(MARKS)
    names = set(named_alike(pattern_of(folder), end, known))
    return posixpath.join(folder, names.pop()) if len(names) == 1 and "." in end else None


def named_alike(folder: re.Pattern[str], end: str, known: Collection[str]) -> Iterator[str]:
    for each in known:
        where, name = posixpath.split(each)
        if folder.fullmatch(where) and name.endswith(end):
            yield name
