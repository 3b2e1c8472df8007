"""The folders that a package's headers are included from."""

from __future__ import annotations

from ..files import PackageFiles

HEADERS = (".hpp", ".h", ".hh", ".hxx")


def include_dirs(files: PackageFiles) -> frozenset[str]:
    """Return the folders with headers below an `include/` folder, relative to it."""
    found = set()
    for path in files.paths:
        if path.endswith(HEADERS) and ("include/" in path):
            _, inside, below = f"/{path}".partition("/include/")
            if inside and "/" in below:
                found.add(below.rpartition("/")[0])
    return frozenset(found)
