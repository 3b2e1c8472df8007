"""What would be written is linted by every rule before it is."""

from __future__ import annotations

from collections.abc import Iterable

from ..engine.run.results import Results
from ..engine.run.scope import Scope
from ..engine.run.session import Session
from ..engine.selection import EVERYTHING
from ..ros.distros import Targets
from ..tree import MemoryTree
from .answers import Answers
from .render import RenderedFile
from .workspace import WorkspacePackages


def lint_written(answers: Answers, files: Iterable[RenderedFile], there: WorkspacePackages) -> Results:
    """Lint a package in memory with all rules, pedantic and release included, for its distribution.

    The packages around that are only in memory too are read with it; of those on disk, the names are known.
    """
    written = {name: tree for name, tree in there.trees.items() if isinstance(tree, MemoryTree)}
    content = {f"{name}/{path}": entry for name, tree in written.items() for path, entry in tree.content.items()}
    tree = MemoryTree({**content, **{f"{answers.name}/{file.path}": file.entry for file in files}})
    scope = Scope(
        tuple(sorted({answers.name, *written})),
        frozenset({answers.name}),
        incomplete="" if there.complete else "packages are missing around it",
        prefix_names=there.installed | frozenset(there.trees),
        index=there.index,
    )
    return Session(tree, scope, EVERYTHING.codes(), Targets((answers.distro.name,))).run()
