"""Packages below a path that are left out, and the marker or folder that hides them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from ...disk_trace import is_file, is_folder, real_path
from ...leftovers import BUILD_FOLDERS
from .discover import PassedBy, marker_above, packages_below

VENDOR_FOLDERS = frozenset("third_party thirdparty vendor vendored external template templates fixtures".split())
"""Folders of others' packages, or of half ones: reported on only when a path leads into them."""

MADE_BY_COLCON = frozenset(BUILD_FOLDERS)


def describe_hidden(paths: Iterable[Path]) -> str:
    """Return a sentence on what hides packages below the paths; "" where there are none."""
    tops = [top for top in map(Path, map(real_path, paths)) if is_folder(top)]
    passed = PassedBy()
    found = [(top, p) for top in tops for p in packages_below(top, marked=True, passed=passed)]
    if not found:
        return describe_made(tops, passed.outputs) or describe_dotted(tops, passed.dotted)
    marks = {hiding_path(top, package).relative_to(top).as_posix(): None for top, package in found}
    others = {1: "", 2: " and another marker"}.get(len(marks), f" and {len(marks) - 1} other markers")
    count = "1 package" if len(found) == 1 else f"{len(found)} packages"
    return f"{count} below, hidden by `{next(iter(marks))}`{others}"


def describe_made(tops: Sequence[Path], outputs: Iterable[Path]) -> str:
    """Return a clause on the folders of colcon that have package.xml files, where nothing else has; "" for none."""
    made = [each for each in sorted(outputs) if holds_made_packages(each)]
    if not made:
        return ""
    top = next(top for top in tops if made[0].is_relative_to(top))
    others = {1: "", 2: " and another folder"}.get(len(made), f" and {len(made) - 1} other folders")
    return f"the packages below `{made[0].relative_to(top).as_posix()}/`{others} are made by colcon and do not count"


def holds_made_packages(output: Path) -> bool:
    """Return whether output of a build is that of colcon, with a package.xml in it or below it."""
    passed = PassedBy()
    is_of_colcon = output.name in MADE_BY_COLCON
    return is_file(output / "package.xml") or (
        is_of_colcon and (next(packages_below(output, passed=passed), None) is not None or bool(passed.outputs))
    )


def describe_dotted(tops: Sequence[Path], dotted: Iterable[Path]) -> str:
    """Return a clause on the folders with a dot before their names that hold packages; "" for none."""
    held = {each: len(list(packages_below(each))) for each in sorted(dotted)}
    holding = [each for each, count in held.items() if count]
    if not holding:
        return ""
    count = sum(held.values())
    top = next(top for top in tops if holding[0].is_relative_to(top))
    others = {1: ", which holds", 2: " and another folder that hold"}.get(
        len(holding), f" and {len(holding) - 1} other folders that hold"
    )
    packages = "1 package" if count == 1 else f"{count} packages"
    return f"colcon does not look into `{holding[0].relative_to(top).as_posix()}/`{others} {packages}"


def hidden_packages(paths: Iterable[Path]) -> list[tuple[Path, Path]]:
    """Return each package below the paths that a run over them leaves out, with what hides it."""
    tops = [top for top in map(Path, map(real_path, paths)) if is_folder(top)]
    every = [(top, package) for top in tops for package in packages_below(top, marked=True)]
    return [(package, by) for top, package in every if (by := hiding_path(top, package)) != package]


def hiding_path(top: Path, package: Path) -> Path:
    """Return the marker, or the folder of others' packages, for which a walk from `top` leaves a package out."""
    folders = (folder for folder in (package, *package.parents) if folder.name in VENDOR_FOLDERS)
    return marker_above(package, top) or next(folders, package)
