"""Rule input: calls of own methods with arguments that these do not take: each raises TypeError."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterator
from functools import cached_property

from ..languages.python.class_members import attributes_set, members_bound
from ..languages.python.file import PythonFile
from ..languages.python.own_reads import own_calls
from ..light_dataclasses import dataclass
from ..ros.rclpy_names import members_of_nodes
from ..source import Span
from .depends.own_classes import Line, OwnClasses
from .kept_objects import START, KeptObjects
from .python.installed_modules import InstalledModules
from .python.refused_arguments import why_refused
from .python.run_imports import RunImports


@dataclass(frozen=True)
class RefusedOwnCalls:
    run: RunImports
    installed: InstalledModules

    def in_file(self, file: PythonFile) -> Iterator[Span]:
        """Yield the calls of a file that the methods of an object itself refuse, where all of its classes are known."""
        yield from (file.span(call) for call, _ in self.calls(file))

    def calls(self, file: PythonFile) -> Iterator[tuple[ast.Call, str]]:
        """Yield these calls with what is wrong with their arguments."""
        if self.is_dynamic:
            return
        yield from self.of_self(file)
        for call, name, line in self.objects.calls(file):
            is_shaped = name == START and any(each.node.decorator_list for each in line.classes)
            may_be_of_node = line.is_node and (name == START or name in members_of_nodes())
            if not is_shaped and not (may_be_of_node and name not in members_bound(line.classes[0].node.body)):
                yield from refused(call, name, line, self.stored)

    def of_self(self, file: PythonFile) -> Iterator[tuple[ast.Call, str]]:
        for owner in self.classes.all:
            line = self.classes.line(owner) if owner.file is file else None
            if line is None:
                continue
            heirs = (one for each in self.classes.heirs(owner.node.name) for one in members_bound(each.node.body))
            others = self.stored.union(heirs)
            for call, method in own_calls(owner.node):
                yield from refused(call, method.attr, line, others)

    @cached_property
    def classes(self) -> OwnClasses:
        return OwnClasses(self.run, self.installed)

    @cached_property
    def objects(self) -> KeptObjects:
        return KeptObjects(self.classes)

    @cached_property
    def is_dynamic(self) -> bool:
        return any("setattr(" in file.source.text for _, file in self.run.files)

    @cached_property
    def stored(self) -> frozenset[str]:
        """Every attribute that code of the package sets: it may be a function."""
        return frozenset(name for _, file in self.run.files for name in attributes_set(file.tree))


def refused(call: ast.Call, name: str, line: Line, others: Collection[str]) -> Iterator[tuple[ast.Call, str]]:
    """Yield a call of a method with what is wrong with it, where each class that has the method refuses it.

    Other names may be something else.
    """
    having = [each.node for each in line.classes if name in members_bound(each.node.body)] if name not in others else []
    found = [has_refusing(each, name, call) for each in having]
    if all(found) and found:
        yield call, found[0]


def has_refusing(owner: ast.ClassDef, name: str, call: ast.Call) -> str:
    """Return why a class refuses a call, where it binds the name by one plain method alone; "" for others."""
    named = [each for each in owner.body if isinstance(each, ast.FunctionDef) and each.name == name]
    members = [*members_bound(owner.body)]
    is_alone = len(named) == 1 == members.count(name) and "__new__" not in members
    is_open = not is_alone or named[0].decorator_list or is_for_heirs(named[0])
    return "" if is_open else why_refused(named[0].args, call)


def is_for_heirs(method: ast.FunctionDef) -> bool:
    """Return whether a method does nothing but say that heirs define it, which those of other packages may do."""
    return method.name != START and all(map(is_empty, method.body))


def is_empty(statement: ast.stmt) -> bool:
    match statement:
        case ast.Pass() | ast.Expr(value=ast.Constant()) | ast.Return(value=None):
            return True
        case ast.Raise(exc=ast.Call(func=ast.Name(id=name)) | ast.Name(id=name)):
            return name == "NotImplementedError"
    return False
