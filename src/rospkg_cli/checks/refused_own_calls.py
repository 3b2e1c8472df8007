"""Rule input: calls of own methods with arguments that these do not take: each raises TypeError."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cached_property

from ..languages.python.attributes import is_of_self
from ..languages.python.class_members import attributes_set, members_bound
from ..languages.python.file import PythonFile
from ..languages.python.nodes import nodes_of_kind
from ..light_dataclasses import dataclass
from ..source import Span
from .depends.own_classes import OwnClasses
from .installed_modules import InstalledModules
from .run_imports import RunImports


@dataclass(frozen=True)
class RefusedOwnCalls:
    run: RunImports
    installed: InstalledModules

    def in_file(self, file: PythonFile) -> Iterator[Span]:
        """Yield the calls of a file that the methods of an object itself refuse, where all of its classes are known."""
        for owner in self.classes.all:
            line = self.classes.line(owner) if owner.file is file else None
            if line is None:
                continue
            heirs = (one for each in self.classes.heirs(owner.node.name) for one in members_bound(each.node.body))
            others = self.stored.union(heirs)
            for call in nodes_of_kind(owner.node, ast.Call):
                if is_of_self(call.func) and call.func.attr not in others:
                    name = call.func.attr
                    having = [each.node for each in line.classes if name in members_bound(each.node.body)]
                    if having and all(has_refusing(each, name, call) for each in having):
                        yield file.span(call)

    @cached_property
    def classes(self) -> OwnClasses:
        return OwnClasses(self.run, self.installed)

    @cached_property
    def stored(self) -> frozenset[str]:
        """Every attribute that code of the package sets: it may be a function."""
        return frozenset(name for _, file in self.run.files for name in attributes_set(file.tree))


def has_refusing(owner: ast.ClassDef, name: str, call: ast.Call) -> bool:
    """Return whether a class binds a name by one plain method alone, which does not take a call."""
    named = [each for each in owner.body if isinstance(each, ast.FunctionDef) and each.name == name]
    is_alone = len(named) == 1 == [*members_bound(owner.body)].count(name)
    return is_alone and not named[0].decorator_list and refuses(named[0].args, call)


def refuses(taken: ast.arguments, call: ast.Call) -> bool:
    """Return whether parameters, of which the first one is the object, don't take a call's arguments."""
    places = [each.arg for each in (*taken.posonlyargs, *taken.args)][1:]
    names = {
        *(each.arg for each in taken.args[0 if taken.posonlyargs else 1 :]),
        *(each.arg for each in taken.kwonlyargs),
    }
    named = {each.arg for each in call.keywords if each.arg is not None}
    given = [each for each in call.args if not isinstance(each, ast.Starred)]
    if (named - names and taken.kwarg is None) or (len(given) > len(places) and taken.vararg is None):
        return True
    if len(given) < len(call.args) or len(named) < len(call.keywords):
        return False
    needed = places[: max(0, len(places) - len(taken.defaults))][len(given) :]
    needed += [each.arg for each, value in zip(taken.kwonlyargs, taken.kw_defaults, strict=True) if value is None]
    return any(each not in named for each in needed)
