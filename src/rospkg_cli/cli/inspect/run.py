"""`rospkg inspect`: what the build will install where, found without building."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import IO

from ...current_folder import current_folder as stands
from ...disk import DiskTree
from ...engine.discovery.choose_configs import choose_configs
from ...engine.discovery.locate import locate
from ...files import PackageFiles
from ...package.inspection import Inspection, inspect_package
from ...package.package import Package
from ...report.color import wants_color
from ...report.inspect_install_table import render_json, render_text
from ...ros.distros import Targets
from .. import UsageError
from ..streams import say


def inspect(
    paths: Sequence[Path] = (),
    *,
    format: str = "text",
    color: str = "auto",
    targets: Sequence[str] = (),
    stream: IO[str] | None = None,
) -> int:
    """Print the install table of the packages at some paths (the current folder, if none); return the exit status.

    `format` is "text" or "json".  Raises UsageError where there is no package, LocateError where there is no such
    path, and ConfigError.
    """
    stream = stream or sys.stdout
    paths = tuple(paths) or (Path(),)
    located = locate(paths, None, choose_configs(paths))
    if not located.scope.selected:
        why = f": {located.hidden}" if located.hidden else ""
        names = ", ".join(f"`{path}`" for path in paths)
        raise UsageError(f"there is no package at {names}{why}; give the path of one")
    tree = DiskTree(located.root, located.scope.folders)
    here = Path(os.path.relpath(located.root, stands())).as_posix()
    chosen = Targets(tuple(targets))
    found = [inspected(tree, folder, located.scope.name, chosen) for folder in sorted(located.scope.selected)]
    inspections = [each for each in found if each is not None]
    if format == "json":
        render_json(inspections, here, stream)
    else:
        render_text(inspections, here, stream, wants_color(color, stream))
    return 0 if len(inspections) == len(found) else 3


def inspected(tree: DiskTree, folder: str, fallback: str, targets: Targets) -> Inspection | None:
    """Inspect one package; after an internal error print it and return None, so that the others are shown."""
    package = Package(PackageFiles(tree.sub(folder), folder))
    try:
        found = inspect_package(package, fallback, targets)
    except Exception as error:
        failure: str | None = f"{type(error).__name__}: {error}"
    else:
        failure = next(iter(package.crashes.values()), "").strip().rpartition("\n")[2]
    if failure:
        where = f"`{folder or fallback}`"
        say(f"{where} can't be inspected: internal error: {failure}; please report it")
        return None
    return found
