"""Switches of Python code that are never thrown, and names that are compared with what they never hold.

A switch is bound once, to True or False, and nowhere else in the package; other names are bound to literals alone, and
parameters have a default that no call replaces.
"""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping

from ...languages.python.constant_truth import constant_truth, unreached_statements
from ...languages.python.file import PythonFile
from ...languages.python.nodes import FunctionNode, children_of, functions_of, nodes_of, nodes_of_kind
from ...languages.python.settled_names import Held, Values, constant_of, settled_in, truths
from ...lazy_regex import regex
from .left_defaults import LeftDefaults

DYNAMIC = regex(r"\bsetattr\(|__dict__|__setattr__")
"""How code sets attributes by names that it makes."""


class Switches:
    """Code of a package that never runs as long as its constants (`DEBUG = False`) are not edited."""

    def __init__(self, files: Iterable[PythonFile]) -> None:
        files = tuple(files)
        found = [each for file in files for each in bound_members(file)]
        times = Counter(name for name, _ in found)
        truths_of = ((name, truth_of(value)) for name, value in found)
        is_dynamic = any(DYNAMIC.search(file.source.text) for file in files)
        self.members = {f"self.{name}": value for name, value in truths_of if value is not None and times[name] == 1}
        self.members = {} if is_dynamic else self.members
        self.defaults = LeftDefaults(files)
        self.values: Values = {} if is_dynamic else dict(settled_members(found, self.defaults.kept))
        self.set_outside = frozenset(times)
        self.known: dict[str, frozenset[int]] = {}

    def given(self, scope: FunctionNode | ast.Module) -> Values:
        """Return what the parameters of a function hold that no call gives a value to."""
        return self.defaults.of(scope) if isinstance(scope, FunctionNode) else {}

    def in_file(self, file: PythonFile) -> dict[str, bool]:
        constants = {name: value for name, value in file.constants.items() if name not in self.set_outside}
        return {**constants, **self.members}

    def turned_off(self, file: PythonFile) -> frozenset[int]:
        """Return the identity of each node under a switch that keeps it from running."""
        if file.path not in self.known:
            self.known[file.path] = frozenset(id(node) for each in self.unreached(file) for node in nodes_of(each))
        return self.known[file.path]

    def statements(self, file: PythonFile) -> Iterator[ast.stmt]:
        """Yield the outermost statements among them."""
        if self.turned_off(file):
            yield from self.unreached(file)

    def choices(self, file: PythonFile) -> Iterator[ast.expr]:
        """Yield the halves of `a if TESTING else b` that a switch never chooses."""
        names = self.in_file(file)
        for each in nodes_of_kind(file.tree, ast.IfExp) if names else []:
            if (always := constant_truth(each.test, names)) is not None:
                yield each.orelse if always else each.body

    def unreached(self, file: PythonFile) -> Iterator[ast.stmt]:
        names, whole = self.in_file(file), self.of_module(file)
        for scope in (file.tree, *functions_of(file.tree)):
            inside = conditions_of(scope)
            own = {**self.given(scope), **settled_in(scope, file)} if inside and scope is not file.tree else {}
            values = {**self.values, **whole, **own}
            yield from unreached_statements(inside, {**names, **truths((each.test for each in inside), values)})

    def of_module(self, file: PythonFile) -> Values:
        """Return the names that a whole file binds to literal values alone, all of them at its top level."""
        if file.has_dynamic_names:
            return {}
        settled = settled_in(file.tree, file)
        inner = {
            name.id
            for each in functions_of(file.tree)
            for name in nodes_of_kind(each, ast.Name)
            if isinstance(name.ctx, ast.Store)
        }
        return {name: held for name, held in settled.items() if name not in inner | self.set_outside}


def conditions_of(scope: FunctionNode | ast.Module) -> list[ast.If]:
    """Return the conditions that stand in a scope itself, and not in a function in it."""
    found: list[ast.If] = []
    waiting: list[ast.AST] = [*scope.body]
    while waiting:
        node = waiting.pop()
        found += [node] if isinstance(node, ast.If) else []
        if isinstance(node, ast.stmt | ast.ExceptHandler | ast.match_case) and not isinstance(node, FunctionNode):
            waiting += children_of(node)
    return found


def settled_members(
    found: Iterable[tuple[str, ast.expr | None]], kept: Mapping[int, Held]
) -> Iterator[tuple[str, frozenset[Held]]]:
    """Yield the members that literal values alone are given to, with all of these; of some values it is known."""
    held: dict[str, set[Held | None]] = {}
    for name, value in found:
        held.setdefault(name, set()).add(kept.get(id(value)) or constant_of(value))
    for name, values in held.items():
        if None not in values:
            yield f"self.{name}", frozenset(each for each in values if each is not None)


def bound_members(file: PythonFile) -> Iterator[tuple[str, ast.expr | None]]:
    """Yield what code makes a member of a class or an object, with its value where that is assigned alone."""
    for assigned in nodes_of_kind(file.tree, ast.Assign):
        for target in assigned.targets:
            if isinstance(target, ast.Attribute):
                yield target.attr, assigned.value
    plain = {id(target) for each in nodes_of_kind(file.tree, ast.Assign) for target in each.targets}
    for attribute in nodes_of_kind(file.tree, ast.Attribute):
        if not isinstance(attribute.ctx, ast.Load) and id(attribute) not in plain:
            yield attribute.attr, None
    for owner in nodes_of_kind(file.tree, ast.ClassDef):
        for each in owner.body:
            if isinstance(each, ast.Assign):
                yield from ((target.id, each.value) for target in each.targets if isinstance(target, ast.Name))
            elif isinstance(each, ast.AnnAssign) and isinstance(each.target, ast.Name):
                yield each.target.id, None  # of a dataclass who makes an object gives another


def truth_of(value: ast.expr | None) -> bool | None:
    return value.value if isinstance(value, ast.Constant) and isinstance(value.value, bool) else None
