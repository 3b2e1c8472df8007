"""Changes as unified diffs."""

from __future__ import annotations

import difflib
from collections.abc import Iterator

from ..engine.apply import Changes
from ..tree import Entry, Tree


def unified(tree: Tree, changes: Changes) -> Iterator[str]:
    """Yield the diff of each changed file, by path."""
    for path, after in sorted(changes.items()):
        try:
            before: Entry | None = tree.entry(path)
        except OSError:
            before = None
        yield diff(path, before, after)


def diff(path: str, before: Entry | None, after: Entry | None) -> str:
    """Return one file's diff; a change of mode alone is one line."""
    old = before.text.text.splitlines(keepends=True) if before else []
    new = after.text.text.splitlines(keepends=True) if after else []
    if before and after and old == new:
        return f"mode {before.mode & 0o777:o} => {after.mode & 0o777:o} {path}\n"
    names = f"a/{path}" if before else "/dev/null", f"b/{path}" if after else "/dev/null"
    lines = list(difflib.unified_diff(old, new, *names))
    if not lines:
        return f"--- {names[0]}\n+++ {names[1]}\n"
    return "".join(line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in lines)
