"""Packages below a path that are left out, and the marker or folder that hides them."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from ...disk_trace import is_folder, real_path
from .discover import marker_above, packages_below

VENDOR_FOLDERS = frozenset("third_party thirdparty vendor vendored external template templates fixtures".split())
"""Folders of others' packages, or of half ones: reported on only when a path leads into them."""


def describe_hidden(paths: Iterable[Path]) -> str:
    """Return a sentence on what hides packages below the paths; "" where there are none."""
    tops = [top for top in map(Path, map(real_path, paths)) if is_folder(top)]
    found = [(top, p) for top in tops for p in packages_below(top, marked=True)]
    if not found:
        return ""
    marks = {hiding_path(top, package).relative_to(top).as_posix(): None for top, package in found}
    others = {1: "", 2: " and another marker"}.get(len(marks), f" and {len(marks) - 1} other markers")
    count = "1 package" if len(found) == 1 else f"{len(found)} packages"
    return f"{count} below, hidden by `{next(iter(marks))}`{others}"


def hidden_packages(paths: Iterable[Path]) -> list[tuple[Path, Path]]:
    """Return each package below the paths that a run over them leaves out, with what hides it."""
    tops = [top for top in map(Path, map(real_path, paths)) if is_folder(top)]
    every = [(top, package) for top in tops for package in packages_below(top, marked=True)]
    return [(package, by) for top, package in every if (by := hiding_path(top, package)) != package]


def hiding_path(top: Path, package: Path) -> Path:
    """Return the marker, or the folder of others' packages, for which a walk from `top` leaves a package out."""
    folders = (folder for folder in (package, *package.parents) if folder.name in VENDOR_FOLDERS)
    return marker_above(package, top) or next(folders, package)
