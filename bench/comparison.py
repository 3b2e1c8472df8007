"""docs/comparison.md: what other tools write, each cell with the place in their source that says so (comparison.toml).

    python -m bench.comparison CLONES       check every cell against git clones named OWNER+NAME or OWNER+NAME/repo
    python -m bench.comparison --write      write the table into docs/comparison.md

A cell says something `since` its evidence holds at the commit: `path:REGEX` is found there, `!path:REGEX` is not. A
path ends at the first `:`, and is empty for the whole repository; without a regular expression, a file of that name
(with `*`) is there.
"""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator
from fnmatch import fnmatch
from pathlib import Path
from typing import Any

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

PAGE = Path(__file__).parents[1] / "docs/comparison.md"
BEGIN, END = "<!-- begin: python -m bench.comparison --write -->\n", "<!-- end -->"
DATA: dict[str, list[dict[str, Any]]] = tomllib.loads((Path(__file__).parent / "comparison.toml").read_text("utf-8"))
TOOLS, ROWS = DATA["tools"], DATA["rows"]


def holds(evidence: str, clone: Path, commit: str) -> bool:
    """Return whether a repository shows the evidence at a commit."""
    path, _, pattern = evidence.removeprefix("!").partition(":")
    if pattern:
        found = bool(git(clone, "grep", "-lE", "-e", pattern, commit, *(["--", path] if path else [])).strip())
    else:
        found = any(fnmatch(name, path) for name in git(clone, "ls-tree", "-r", "--name-only", commit).splitlines())
    return found is not evidence.startswith("!")


def git(clone: Path, *words: str) -> str:
    done = subprocess.run(["git", "-C", str(clone), *words], capture_output=True, text=True, check=False)
    if done.returncode > 1:
        raise SystemExit(f"{clone}: {done.stderr.strip()}")
    return done.stdout


def wrong_cells(clones: Path) -> Iterator[str]:
    for tool in TOOLS:
        place = clones / tool["repository"].replace("/", "+")
        clone = place / "repo" if (place / "repo").is_dir() else place
        for row in ROWS:
            cell = row[tool["title"]]
            for evidence in cell["since"]:
                if not holds(evidence, clone, tool["commit"]):
                    yield f"{tool['title']}, {row['title']}: `{cell['says']}` is not what {evidence} shows"


def table() -> str:
    """Return the table of the page."""
    links = [f"[{t['title']}](https://github.com/{t['repository']}/tree/{t['commit'][:12]})" for t in TOOLS]
    columns = [*(tool["title"] for tool in TOOLS), "rospkg"]
    rows = [[row["title"], *(row[column]["says"] for column in columns)] for row in ROWS]
    lines = [["", *links, "rospkg"], ["---"] * (len(columns) + 1), *rows]
    return "".join(f"| {' | '.join(cells)} |\n" for cells in lines)


def with_table(page: str) -> str:
    return re.sub(f"(?s)(?<={re.escape(BEGIN)}).*?(?={re.escape(END)})", lambda _: f"\n{table()}\n", page)


def main(words: list[str]) -> int:
    if words == ["--write"]:
        PAGE.write_text(with_table(PAGE.read_text("utf-8")), "utf-8")
        return 0
    [clones] = words
    wrong = list(wrong_cells(Path(clones)))
    print("\n".join([*wrong, f"{len(ROWS) * len(TOOLS)} cells, {len(wrong)} wrong"]))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
