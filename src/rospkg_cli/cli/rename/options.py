"""The options of `rospkg rename`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from ..complete import package_names

EPILOG = "Examples:  rospkg rename my_robot robot_base  ·  rospkg rename node talker chatter"
NAMES = "A package, by its name or its path, and its new name; `node` OLD NEW for an executable of a package."
PACKAGE = "The package of the node: its folder, a path in it, or its name below the current folder."
DIFF = "Show what would change; exit with status 1 if anything would."
DIRTY = "Go ahead where git could not bring the old files back."


def rename(
    names: Annotated[
        list[str], Argument(metavar="[node] OLD NEW", help=NAMES, show_default=False, autocompletion=package_names)
    ],
    package: Annotated[Path, Option("--package", "-p", metavar="PATH", help=PACKAGE)] = Path(),
    dry_run: Annotated[bool, Option("--dry-run", help="Show which files would change; write nothing.")] = False,
    diff: Annotated[bool, Option("--diff", help=DIFF)] = False,
    allow_dirty: Annotated[bool, Option("--allow-dirty", help=DIRTY)] = False,
) -> int:
    """Give a package or a node another name, in every file of the workspace that uses it."""
    from ..change.finish import ChangeOptions
    from .run import rename as run

    return run(names, package, ChangeOptions(dry_run, diff), allow_dirty)
