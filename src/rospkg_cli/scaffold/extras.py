"""What `--with` adds to a package of any type."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from ..light_dataclasses import replace
from ..resources import resources
from . import ScaffoldError
from .short_words import closest_name
from .template import Template, TemplateFile, files_of

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

OF_GITHUB = "ci"

NONE = "none"
"""What takes back the extras that a package was written with."""


def without_none(asked: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(name for name in asked if name != NONE)


@cache
def extras_table() -> dict[str, Any]:
    table: dict[str, Any] = tomllib.loads((resources("templates") / "_shared" / "extras.toml").read_text("utf-8"))
    return table


@cache
def all_extras() -> dict[str, tuple[TemplateFile, ...]]:
    """Return the files of every extra by its name."""
    table = extras_table().items()
    return {name: tuple(replace(file, brackets=True) for file in files_of(row["files"])) for name, row in table}


def extras_with_meaning() -> dict[str, str]:
    """Return each extra with what it is, in a few words."""
    return {name: row["about"] for name, row in extras_table().items()}


@cache
def workspace_extras() -> dict[str, tuple[TemplateFile, ...]]:
    """Return the files of the extras that the root of a workspace may have."""
    sources = {name: row["workspace"] for name, row in extras_table().items() if "workspace" in row}
    return {name: tuple(replace(file, source=sources[name]) for file in all_extras()[name]) for name in sources}


def with_extras(
    template: Template, asked: tuple[str, ...], known: Mapping[str, tuple[TemplateFile, ...]] | None = None
) -> Template:
    """Return a template that writes the extras too, those of a package unless others are known.

    Raises ScaffoldError for unknown ones.
    """
    known = all_extras() if known is None else known
    for name in asked:
        if name in all_extras() and name not in known:
            raise ScaffoldError(f"`{name}` is for a package; leave it out of --with here: {', '.join(known)} remain")
        if name not in known:
            raise ScaffoldError(f"--with knows no `{name}`{closest_name(name, known)}; known: {', '.join(known)}")
    extra = [file for name in dict.fromkeys(asked) for file in known[name]]
    return replace(template, files=(*template.files, *extra))


def notes_on_extras(asked: tuple[str, ...], folder: Path) -> Iterator[str]:
    """Yield what the user should hear of extras in a folder."""
    root = next((each for each in (folder.absolute(), *folder.absolute().parents) if (each / ".git").exists()), None)
    if OF_GITHUB in asked and root:
        yield f"GitHub reads workflows only from the root of a repository: move `.github` to `{root}`"
