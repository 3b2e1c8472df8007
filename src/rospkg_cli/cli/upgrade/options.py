"""The options of `rospkg upgrade`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from ..complete import choices, distro_names

EPILOG = "Examples:  rospkg upgrade --to lyrical  ·  rospkg upgrade src/ --to lyrical --write"
TO = "The distribution to move to."
WRITE = "Write what is shown without it."
DIRTY = "Go ahead where git could not bring the old files back."


def upgrade(
    paths: Annotated[list[Path] | None, Argument(help="Packages, or folders of packages.")] = None,
    to: Annotated[str, Option("--to", metavar="DISTRO", help=TO, autocompletion=choices(*distro_names()))] = "",
    write: Annotated[bool, Option("--write", help=WRITE)] = False,
    allow_dirty: Annotated[bool, Option("--allow-dirty", help=DIRTY)] = False,
) -> int:
    """Change packages for a newer ROS distribution, and say what is left to do by hand."""
    from .run import upgrade as run

    return run(tuple(paths or (Path(),)), to, write, allow_dirty)
