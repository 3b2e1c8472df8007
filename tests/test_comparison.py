"""docs/comparison.md: its table is that of bench/comparison.toml, and what it says of rospkg is so."""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
from in_process import Done, run_here

sys.path.insert(0, str(Path(__file__).parents[1]))

from bench.comparison import PAGE, ROWS, TOOLS, holds, with_table


def test_the_page_has_the_table() -> None:
    page = PAGE.read_text("utf-8")
    assert with_table(page) == page, "write it with: python -m bench.comparison --write"
    for tool in TOOLS:
        assert tool["commit"][:12] in page
        assert re.fullmatch(r"\d{4}-\d\d-\d\d", tool["date"])


def test_each_cell_has_evidence() -> None:
    assert not [(row["title"], tool["title"]) for row in ROWS for tool in TOOLS if not row[tool["title"]]["since"]]


def test_each_cell_of_readme_says_how_it_was_checked() -> None:
    readme = (PAGE.parents[1] / "README.md").read_text("utf-8").partition("## Beside other tools")[2]
    head, _, *rows = [cells(line) for line in readme.partition("\n## ")[0].splitlines() if line.startswith("|")]
    page = PAGE.read_text("utf-8").partition("## The table in README")[2]
    checked = [cells(line) for line in page.splitlines() if line.startswith("|")][2:]
    assert [row[:3] for row in checked] == [
        [title, tool, cell or "–"] for title, _, *found in rows for tool, cell in zip(head[2:], found, strict=True)
    ]
    assert all(row[3] for row in checked)


def cells(line: str) -> list[str]:
    return [cell.strip() for cell in line.strip("|\n").split("|")]


@cache
def run(command: str) -> Done:
    """Run a command in a folder of its own; several rows ask for the same."""
    with TemporaryDirectory() as place:
        return run_here(*shlex.split(command), cwd=Path(place), COLUMNS="300")


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row["title"])
def test_what_it_says_of_rospkg_is_so(row: dict[str, Any]) -> None:
    ours = row["rospkg"]
    done = run(ours["command"])
    assert done.returncode == ours["status"]
    assert ours["shows"] in done.stdout + done.stderr


EVIDENCE = {
    "a/b.txt:wor[dl]s": True,
    "a/b.txt:sentence": False,
    "!a/b.txt:sentence": True,
    "!:words": False,
    "a:^words$": True,
    "a/*.txt": True,
    "!a/c.txt": True,
    "a/c.txt": False,
}


def test_evidence_is_looked_for_at_the_commit(tmp_path: Path) -> None:
    def git(*words: str) -> None:
        who = ["-c", "user.name=Ada", "-c", "user.email=ada@example.org"]
        subprocess.run(["git", "-C", str(tmp_path), *who, *words], check=True)

    git("init", "-q")
    (tmp_path / "a").mkdir()
    (tmp_path / "a/b.txt").write_text("words\n")
    git("add", ".")
    git("commit", "-qm", "first")
    (tmp_path / "a/b.txt").write_text("another sentence\n")
    assert {text: holds(text, tmp_path, "HEAD") for text in EVIDENCE} == EVIDENCE
