"""The options of `rospkg format`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from typer import Argument, Option

EPILOG = "Examples:  rospkg format  ·  rospkg format src/ --check  ·  rospkg format . --diff"


def format(
    paths: Annotated[list[Path] | None, Argument(help="Packages, folders of packages, or files in them.")] = None,
    check: Annotated[
        bool, Option("--check", help="Change nothing; exit with status 1 if something would change.")
    ] = False,
    diff: Annotated[bool, Option("--diff", help="As --check, and show what would change.")] = False,
) -> int:
    """Put package.xml in canonical order: elements as in the schema, dependencies sorted; nothing else changes."""
    from .run import format_manifests

    return format_manifests(paths or (), check, diff)
