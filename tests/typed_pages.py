"""The command lines of README and of the pages, in the order in which somebody reads and types them."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parents[1]
PAGES = tuple(
    path.relative_to(ROOT).as_posix()
    for path in (
        *(ROOT / name for name in ("README.md", "CONTRIBUTING.md", "SECURITY.md", "editors/vscode/README.md")),
        *sorted((ROOT / "docs").rglob("*.md")),
    )
)
FENCED = re.compile(r"""^\s*(?:- run: |- |"command": ")(rospkg [^"]*)|(?<=makeprg=)(rospkg\\.*?)(?= \w)""")
SPAN = re.compile(r"(?<!`)`(rospkg [^`]+)`(?!`)")


@dataclass(frozen=True)
class Typed:
    """A command line of a page: its section, what stands beside it, and the lines that it is said to print."""

    section: str
    line: str
    beside: str = ""
    prints: tuple[str, ...] = ()
    is_span: bool = False


def typed(page: str) -> list[Typed]:
    """Return the command lines of a page: indented ones, those of CI files and editors, and spans of code."""
    return list(lines_of((ROOT / page).read_text("utf-8")))


def lines_of(text: str) -> Iterator[Typed]:
    section, fenced, lines = "", False, text.splitlines()
    for number, line in enumerate(lines):
        if line.startswith("```"):
            fenced = not fenced
        elif fenced:
            yield from (Typed(section, (a or b).replace("\\ ", " ")) for a, b in FENCED.findall(line))
        elif line.startswith("#"):
            section = line.strip("# ")
        elif line.startswith("    $ "):
            yield Typed(section, line[6:], prints=tuple(shown(lines[number + 1 :])))
        elif line.startswith("    "):
            if not is_shown(lines[:number]):
                command, _, beside = re.sub(r" {2,}", "\0", line.strip(), count=1).partition("\0")
                yield Typed(section, command, beside.strip())
        else:
            yield from (Typed(section, span, is_span=True) for span in SPAN.findall(line))


def shown(lines: list[str]) -> Iterator[str]:
    """Yield what a block says below a command."""
    for line in lines:
        if not line.startswith("    "):
            return
        yield " ".join(line.split())


def is_shown(before: list[str]) -> bool:
    """Return whether the lines before are a block that begins with a command and goes on with what it prints."""
    block = next((at for at in range(len(before), 0, -1) if not before[at - 1].startswith("    ")), 0)
    return block < len(before) and before[block].startswith("    $ ")
