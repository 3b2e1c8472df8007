"""Objects of a package's own classes that code makes and keeps under one name, and what it calls of them."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator
from functools import cached_property

from ..languages.python.attributes import is_of_self
from ..languages.python.file import PythonFile
from ..languages.python.nodes import FunctionNode, functions_of, nodes_of_kind
from ..languages.python.settled_names import bound_otherwise
from ..light_dataclasses import dataclass
from .depends.own_classes import Line, OwnClasses
from .python.switches import bound_members

START = "__init__"


@dataclass(frozen=True)
class KeptObjects:
    classes: OwnClasses

    def calls(self, file: PythonFile) -> Iterator[tuple[ast.Call, str, Line]]:
        """Yield each call of a known object with the name of its method, and each call that makes such an object."""
        members = {each.attr: line for each, value in members_given(file) if (line := self.made_by(file, value))}
        members = {name: line for name, line in members.items() if self.times_stored[name] == 1}
        for call in nodes_of_kind(file.tree, ast.Call):
            if line := self.made_by(file, call):
                yield call, START, line
            elif isinstance(call.func, ast.Attribute) and is_of_self(held := call.func.value) and held.attr in members:
                yield call, call.func.attr, members[held.attr]
        for scope in (file.tree, *functions_of(file.tree)):
            names = self.names_in(scope, file)
            for call in nodes_of_kind(scope, ast.Call) if names else ():
                match call.func:
                    case ast.Attribute(value=ast.Name(id=name), attr=method) if name in names:
                        yield call, method, names[name]

    def names_in(self, scope: FunctionNode | ast.Module, file: PythonFile) -> dict[str, Line]:
        """Return the names that a scope binds once, and to a new object."""
        found, times, plain = dict[str, Line](), Counter[str](), set[int]()
        for each in nodes_of_kind(scope, ast.Assign):
            match each.targets:
                case [ast.Name(id=name) as target]:
                    plain.add(id(target))
                    times[name] += 1
                    if line := self.made_by(file, each.value):
                        found[name] = line
        if not found:
            return found
        others = {*bound_otherwise(scope, plain)}
        others.update(name for each in nodes_of_kind(file.tree, ast.Global) for name in each.names)
        others.update(name for each in nodes_of_kind(file.tree, ast.Nonlocal) for name in each.names)
        return {name: line for name, line in found.items() if times[name] == 1 and name not in others}

    def made_by(self, file: PythonFile, value: ast.expr | None) -> Line | None:
        """Return the class of a new object with its bases, where all of these are known."""
        match value:
            case ast.Call(func=ast.Name(id=name)) if self.classes.times_bound(file, name) == 1:
                line = self.classes.base(file, value.func, 0)
                return line if isinstance(line, Line) else None
        return None

    @cached_property
    def times_stored(self) -> Counter[str]:
        """How often code of the package gives something to a member of each name."""
        return Counter(name for _, file in self.classes.run.files for name, _ in bound_members(file))


def members_given(file: PythonFile) -> Iterator[tuple[ast.Attribute, ast.expr]]:
    for each in nodes_of_kind(file.tree, ast.Assign):
        match each.targets:
            case [target] if is_of_self(target):
                yield target, each.value
