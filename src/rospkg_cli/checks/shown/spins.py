"""Programs of which all is seen, and in which nothing spins a node: no executor calls its callbacks."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cached_property

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ..behind_loops import is_behind_loop
from .handed_nodes import HandedNodes
from .meanings import Own
from .steps import Steps

SPINS = regex(r"(?i)\w*(?:spin|executor)\w*")
HIDING = frozenset({"exec", "eval", "__import__", "import_module", "run_path", "run_module", "globals"})
"""Calls of what is not to be seen."""


@dataclass(frozen=True)
class Spins:
    steps: Steps

    def may_be_in(self, file: PythonFile) -> bool:
        """Return whether a program that a file begins may spin a node, in the files that it imports, too."""
        return any(self.may_spin(each) for each in self.files(file))

    def files(self, file: PythonFile) -> Iterator[PythonFile]:
        """Yield a file and the own ones that it imports, at whatever distance."""
        waiting, seen = [file], {file.path}
        for each in waiting:
            yield each
            unit = Own(each, each.tree)
            for other in (step.to.file for node in imports_of(each) for step in self.steps.imported(unit, node)):
                if other.path not in seen:
                    seen.add(other.path)
                    waiting.append(other)

    @cached_property
    def known(self) -> dict[str, bool]:
        return {}

    def may_spin(self, file: PythonFile) -> bool:
        if file.path not in self.known:
            is_named = any(self.is_met(file, node) for node in naming(file))
            self.known[file.path] = is_named or HandedNodes(self.steps, file).may_be_spun
        return self.known[file.path]

    def is_met(self, file: PythonFile, node: ast.AST) -> bool:
        """Return whether a name that spins is come to while the program works."""
        if not isinstance(node, ast.expr | ast.keyword):
            return True
        return not is_behind_loop(self.steps.meanings, file, file.span(node))


def imports_of(file: PythonFile) -> Iterator[ast.Import | ast.ImportFrom]:
    yield from nodes_of_kind(file.tree, ast.Import)
    yield from nodes_of_kind(file.tree, ast.ImportFrom)


def naming(file: PythonFile) -> Iterator[ast.AST]:
    """Yield the nodes that name what spins, or what calls code that is not to be seen."""
    yield from (each for each in nodes_of_kind(file.tree, ast.Name) if SPINS.fullmatch(each.id) or each.id in HIDING)
    for one in nodes_of_kind(file.tree, ast.Attribute):
        yield from [one] if SPINS.fullmatch(one.attr) or one.attr in HIDING else []
    for text in nodes_of_kind(file.tree, ast.Constant):
        yield from [text] if isinstance(text.value, str) and SPINS.fullmatch(text.value) else []
    for given in nodes_of_kind(file.tree, ast.keyword):
        yield from [given] if SPINS.fullmatch(given.arg or "") else []
    for alias in nodes_of_kind(file.tree, ast.alias):
        yield from [alias] if alias.asname and SPINS.fullmatch(alias.name) else []
