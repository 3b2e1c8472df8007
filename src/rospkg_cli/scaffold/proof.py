"""What would be written is linted by every rule before it is."""

from __future__ import annotations

from collections.abc import Iterable

from ..engine.selection import EVERYTHING
from ..engine.session import Results, Scope, Session
from ..ros.distros import Targets
from ..tree import MemoryTree
from .answers import Answers
from .render import Written


def lint_written(answers: Answers, files: Iterable[Written]) -> Results:
    """Lint a package in memory with all rules, pedantic and release included, for its distribution."""
    tree = MemoryTree({f"{answers.name}/{file.path}": file.entry for file in files})
    scope = Scope((answers.name,), frozenset({answers.name}))
    return Session(tree, scope, EVERYTHING.codes(), Targets((answers.distro.name,))).run()
