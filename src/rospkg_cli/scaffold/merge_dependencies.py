"""Conflicts about the dependencies in package.xml, whose order means nothing: both sides' are taken."""

from __future__ import annotations

import re

CONFLICT = re.compile(rb"<<<<<<< yours\r?\n(?P<yours>.*?)=======\r?\n(?P<new>.*?)>>>>>>> rospkg\r?\n", re.DOTALL)
DEPENDENCY = re.compile(rb"[ \t]*<(\w*depend)>[^<>\s]+</\1>\r?\n")


def with_all_dependencies(merged: bytes, base: bytes) -> tuple[bytes, int]:
    """Return a merged file without the conflicts that are about dependencies alone, and how many these were.

    A line of one side stays where it is new; it goes where it stood in `base` and the other side has removed it.
    """
    written, solved = set(base.splitlines(keepends=True)), 0

    def of_both(conflict: re.Match[bytes]) -> bytes:
        nonlocal solved
        yours, new = (conflict[side].splitlines(keepends=True) for side in ("yours", "new"))
        if not all(DEPENDENCY.fullmatch(line) or not (line.strip() or (yours and new)) for line in (*yours, *new)):
            return conflict[0]
        solved += 1
        if not (yours and new):  # a group with the blank line behind it
            return b"".join(line for line in (*yours, *new) if not line.strip() or line not in written)
        kept = [line for line in yours if line in new or line not in written]
        kept += [line for line in new if line not in yours and line not in written]
        return b"".join(sorted(kept) if yours == sorted(yours) else kept)

    return CONFLICT.sub(of_both, merged), solved
