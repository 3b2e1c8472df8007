"""The options of `rospkg doctor`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from ..arguments import one_of

EPILOG = "Examples:  rospkg doctor  ·  rospkg doctor src/  ·  rospkg doctor --format json"


def doctor(
    paths: Annotated[list[Path] | None, Argument(help="Packages, or folders of packages.")] = None,
    format: Annotated[str, Option("--format", metavar="FORMAT", help="text, or json for a bug report.")] = "text",
) -> int:
    """Show what decides about a lint here: config, workspace, index, plugins, ROS, cache."""
    from .run import doctor as examine

    one_of("--format", format, ("text", "json"))
    return examine(tuple(paths or ()), format)
