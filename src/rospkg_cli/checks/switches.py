"""Switches of Python code that are never thrown: bound once, to True or False, and nowhere else in the package."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterable, Iterator

from ..languages.python.constant_truth import unreached_nodes, unreached_statements
from ..languages.python.file import PythonFile
from ..languages.python.nodes import nodes_of_kind
from ..lazy_regex import regex

DYNAMIC = regex(r"\bsetattr\(|__dict__|__setattr__")
"""How code sets attributes by names that it makes."""


class Switches:
    """What a package's code is sure never to reach, as long as nobody edits a switch."""

    def __init__(self, files: Iterable[PythonFile]) -> None:
        files = tuple(files)
        found = [each for file in files for each in bound_members(file)]
        times = Counter(name for name, _ in found)
        is_dynamic = any(DYNAMIC.search(file.source.text) for file in files)
        self.members = {f"self.{name}": value for name, value in found if value is not None and times[name] == 1}
        self.members = {} if is_dynamic else self.members
        self.set_outside = frozenset(times)
        self.known: dict[str, frozenset[int]] = {}

    def in_file(self, file: PythonFile) -> dict[str, bool]:
        constants = {name: value for name, value in file.constants.items() if name not in self.set_outside}
        return {**constants, **self.members}

    def turned_off(self, file: PythonFile) -> frozenset[int]:
        """Return the identity of each node under a switch that keeps it from running."""
        if file.path not in self.known:
            names = self.in_file(file)
            nodes = nodes_of_kind(file.tree, ast.If)
            self.known[file.path] = frozenset(unreached_nodes(nodes, names))
        return self.known[file.path]

    def statements(self, file: PythonFile) -> Iterator[ast.stmt]:
        """Yield the outermost statements among them."""
        if self.turned_off(file):
            yield from unreached_statements(nodes_of_kind(file.tree, ast.If), self.in_file(file))


def bound_members(file: PythonFile) -> Iterator[tuple[str, bool | None]]:
    """Yield what code makes a member of a class or an object, with its value where that is True or False."""
    for assigned in nodes_of_kind(file.tree, ast.Assign):
        for target in assigned.targets:
            if isinstance(target, ast.Attribute):
                yield target.attr, truth_of(assigned.value)
    plain = {id(target) for each in nodes_of_kind(file.tree, ast.Assign) for target in each.targets}
    for attribute in nodes_of_kind(file.tree, ast.Attribute):
        if not isinstance(attribute.ctx, ast.Load) and id(attribute) not in plain:
            yield attribute.attr, None
    for owner in nodes_of_kind(file.tree, ast.ClassDef):
        for each in owner.body:
            targets = each.targets if isinstance(each, ast.Assign) else ()
            yield from (
                (t.id, truth_of(each.value))
                for t in targets
                if isinstance(t, ast.Name) and isinstance(each, ast.Assign)
            )


def truth_of(value: ast.expr) -> bool | None:
    return value.value if isinstance(value, ast.Constant) and isinstance(value.value, bool) else None
