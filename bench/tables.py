"""Write a table of src/rospkg_cli/ros/tables with the header that every one of them has."""

from __future__ import annotations

import subprocess
import textwrap
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import date
from pathlib import Path

TABLES = Path(__file__).parents[1] / "src/rospkg_cli/ros/tables"
WIDTH = 116


@dataclass(frozen=True)
class Revision:
    commit: str
    date: str
    """ISO 8601."""


@dataclass(frozen=True)
class Origin:
    source: str
    license: str
    """The SPDX ids of the source, by commas."""
    script: str
    """The one that writes the table, below the root of the repository."""


def revision_of(folder: Path) -> Revision:
    """Return the commit of a checkout; of another folder the date of its newest file."""
    if (folder / ".git").exists():
        asked = ["git", "-C", str(folder), "log", "-1", "--format=%H %cs"]
        commit, day = subprocess.run(asked, check=True, capture_output=True, text=True).stdout.split()
        return Revision(commit, day)
    newest = max(path.stat().st_mtime for path in folder.rglob("*") if path.is_file())
    return Revision("unknown", date.fromtimestamp(newest).isoformat())


def header(about: str, origin: Origin, revision: Revision) -> list[str]:
    """Return the lines that a table begins with."""
    fields = {
        "source": origin.source,
        "commit": revision.commit,
        "date": revision.date,
        "license": origin.license,
        "made by": origin.script,
    }
    return [f"# {line}" for line in textwrap.wrap(about, WIDTH)] + [f"# {key}: {fields[key]}" for key in fields]


def write(name: str, about: str, rows: Iterable[str], origin: Origin, revision: Revision) -> None:
    text = "\n".join([*header(about, origin, revision), *rows]) + "\n"
    (TABLES / name).write_text(text, encoding="utf-8")
