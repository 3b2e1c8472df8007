"""The options of `rospkg rename`."""

from __future__ import annotations

from typing import Annotated

from typer import Argument, Option

from ..complete import package_names

EPILOG = "Examples:  rospkg rename my_robot robot_base  ·  rospkg rename my_robot robot_base --diff"
NAMES = "The package, by its name or its path, and its new name."
DIFF = "Show what would change; exit with status 1 if anything would."
DIRTY = "Go ahead where git could not bring the old files back."


def rename(
    names: Annotated[
        list[str], Argument(metavar="OLD NEW", help=NAMES, show_default=False, autocompletion=package_names)
    ],
    dry_run: Annotated[bool, Option("--dry-run", help="Show which files would change; write nothing.")] = False,
    diff: Annotated[bool, Option("--diff", help=DIFF)] = False,
    allow_dirty: Annotated[bool, Option("--allow-dirty", help=DIRTY)] = False,
) -> int:
    """Give a package another name, in every file of the workspace that uses it."""
    from ..change.finish import ChangeOptions
    from .run import rename as run

    return run(names, ChangeOptions(dry_run, diff), allow_dirty)
