"""Changes as unified diffs."""

from __future__ import annotations

import difflib
from collections.abc import Iterator

from ..control_characters import visible, visible_lines, without_workflow_commands
from ..engine.fixing.apply import Changes
from ..tree import Tree, TreeEntry


def unified(tree: Tree, changes: Changes) -> Iterator[str]:
    """Yield the diff of each changed file, by path."""
    for path, after in sorted(changes.items()):
        try:
            before: TreeEntry | None = tree.entry(path)
        except OSError:
            before = None
        yield diff(path, before, after)


def diff(path: str, before: TreeEntry | None, after: TreeEntry | None) -> str:
    """Return one file's diff, in which nothing is left that a terminal or a log would obey.

    A change of mode alone is one line. Raises UnicodeError where a file is no text.
    """
    path = visible(path)
    old = lines_of(before.text.text) if before else []
    new = lines_of(after.text.text) if after else []
    if before and after and old == new:
        return f"mode {before.mode & 0o777:o} => {after.mode & 0o777:o} {path}\n"
    names = f"a/{path}" if before else "/dev/null", f"b/{path}" if after else "/dev/null"
    lines = list(difflib.unified_diff(old, new, *names))
    if not lines:
        return f"--- {names[0]}\n+++ {names[1]}\n"
    shown = (line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in lines)
    return without_workflow_commands(visible_lines("".join(shown)))


def lines_of(text: str) -> list[str]:
    """Return the lines of a text, each with its end: at line feeds alone, as diff and patch count them."""
    return [f"{line}\n" for line in text.split("\n")[:-1]] + [last for last in [text.rpartition("\n")[2]] if last]
