"""Lint a tree of plain texts: for tests of rules, and for whoever writes plug-ins."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from .engine.selection import EVERYTHING
from .engine.session import Results, Scope, Session
from .model.discover import packages_in
from .ros.distros import Targets
from .tree import Entry, MemoryTree


def lint_files(
    files: Mapping[str, str | bytes | Entry], codes: Iterable[str] | None = None, targets: tuple[str, ...] = ()
) -> Results:
    """Lint a tree given as path → text with the named rules, or with all of them, pedantic and release included.

    A text that begins with `#!` is an executable file.  A package in the root is called `my_pkg`.
    """
    tree = MemoryTree.of(files)
    folders = packages_in(tree)
    chosen = EVERYTHING.codes() if codes is None else frozenset(codes)
    session = Session(tree, Scope(tuple(folders), frozenset(folders), "my_pkg"), chosen, Targets(targets))
    return session.run() if folders else session.nothing(["."])
