"""What `--with` adds to a package of any type."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from ..light_dataclasses import replace
from ..resources import resources
from ..suggest import did_you_mean
from . import ScaffoldError
from .template import Template, TemplateFile, files_of

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

OF_GITHUB = "ci"


@cache
def all_extras() -> dict[str, tuple[TemplateFile, ...]]:
    """Return the files of every extra by its name."""
    data = tomllib.loads((resources("templates") / "_shared" / "extras.toml").read_text("utf-8"))
    return {name: tuple(replace(file, brackets=True) for file in files_of(row["files"])) for name, row in data.items()}


def with_extras(template: Template, asked: tuple[str, ...]) -> Template:
    """Return a template that writes the extras too; raises ScaffoldError for unknown ones."""
    known = all_extras()
    for name in asked:
        if name not in known:
            raise ScaffoldError(f"--with knows no `{name}`{did_you_mean(name, known)}; known: {', '.join(known)}")
    extra = [file for name in dict.fromkeys(asked) for file in known[name]]
    return replace(template, files=(*template.files, *extra))


def notes_on_extras(asked: tuple[str, ...], folder: Path) -> Iterator[str]:
    """Yield what the user should hear of extras in a folder."""
    root = next((each for each in (folder.absolute(), *folder.absolute().parents) if (each / ".git").exists()), None)
    if OF_GITHUB in asked and root:
        yield f"GitHub reads workflows only from the root of a repository: move `.github` to `{root}`"
