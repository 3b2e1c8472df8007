"""Launch files that no distribution of today can load: launch stops at a keyword that it has no more."""

from __future__ import annotations

from collections.abc import Collection, Iterable

from ...files import PackageFiles
from ...package.launch.launch_file import LaunchFile
from ..repository.older_distribution import OlderDistribution
from .removed_arguments import is_taken_by_old_launch_alone


def are_all_stopped(paths: Iterable[str], launches: Collection[LaunchFile], files: PackageFiles) -> bool:
    """Return whether all files of some paths are launch files for Foxy, and nothing says that Foxy is intended."""
    known, older = {each.path: each for each in launches}, OlderDistribution(files)
    found = [(path, known.get(path)) for path in paths]
    stopped = (file is not None and is_taken_by_old_launch_alone(file) for _, file in found)
    return bool(found) and all(stopped) and not any(older.is_for_older(path) for path, _ in found)
