"""The options of `rospkg inspect`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from ..arguments import one_of, split

EPILOG = "Examples:  rospkg inspect  ·  rospkg inspect src/my_robot_nav  ·  rospkg inspect src/ --format json"


def inspect(
    paths: Annotated[list[Path] | None, Argument(help="Packages, or folders of packages.")] = None,
    format: Annotated[str, Option("--format", metavar="FORMAT", help="text or json.")] = "text",
    target: Annotated[
        list[str] | None, Option(metavar="DISTROS", help="humble, jazzy, …: for conditions in package.xml.")
    ] = None,
    color: Annotated[str, Option(metavar="WHEN", help="auto, always or never.")] = "auto",
) -> int:
    """Show what the build will install where, without building, and what launch files start."""
    from .run import inspect as print_table

    one_of("--format", format, ("text", "json"))
    one_of("--color", color, ("auto", "always", "never"))
    return print_table(tuple(paths or ()), format=format, color=color, targets=split(target))
