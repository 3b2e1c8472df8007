"""`rospkg inspect`: what the build installs where, known without building."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import IO

from ..config import find_config
from ..engine.locate import locate
from ..model.files import PackageFiles
from ..model.inspection import inspect_package
from ..model.package import Package
from ..report.installed import render_json, render_text
from ..report.style import wants_color
from ..ros.distros import Targets
from ..tree import DiskTree
from . import UsageError
from .lint import nearest_folder


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
    located = locate(paths, None, find_config(nearest_folder(paths)))
    if not located.scope.given:
        why = f": {located.hidden}" if located.hidden else ""
        names = ", ".join(f"`{path}`" for path in paths)
        raise UsageError(f"there is no package at {names}{why}; give the path of one")
    tree = DiskTree(located.root)
    here = Path(os.path.relpath(located.root)).as_posix()
    inspections = [
        inspect_package(Package(PackageFiles(tree.sub(folder), folder)), located.scope.name, Targets(tuple(targets)))
        for folder in sorted(located.scope.given)
    ]
    if format == "json":
        render_json(inspections, here, stream)
    else:
        render_text(inspections, here, stream, wants_color(color, stream))
    return 0
