"""Where one node of a function or module leads to: the functions that it calls or hands on, the classes it makes."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Sequence

from ...languages.python.nodes import FunctionNode
from ...light_dataclasses import dataclass, replace
from .meanings import Meanings, Own
from .own_objects import OwnObjects
from .units import Place, Units

ASKING = frozenset({"isinstance", "issubclass", "super", "hasattr", "type", "cast", "TypeVar", "id", "print", "len"})
"""Functions that call nothing of what they are handed."""
PROPERTIES = frozenset({"property", "cached_property", "setter", "getter"})


@dataclass(frozen=True, slots=True)
class Step:
    to: Own
    more: int = 0
    """Conditions that this step has of its own."""
    needs: Own | None = None
    """A class of which there must be an object."""
    is_exact: bool = False
    """Whether an object of an heir does not do."""


@dataclass(frozen=True)
class Steps:
    meanings: Meanings
    objects: OwnObjects
    units: Units

    def of(self, unit: Own, node: ast.AST, handed: set[int]) -> Iterator[Step]:
        """Yield where a node of a unit leads to; `handed` are the nodes that are called or given to a call before."""
        place = self.units.place(unit)
        match node:
            case ast.Call(func=ast.Name(id="getattr"), args=[value, ast.Constant(value=str(name)), *_]):
                named = ast.Attribute(value, name, ast.Load())
                yield from self.of_object(unit, place, named, is_call=True)
            case ast.Call(func=called):
                handed.add(id(called))
                yield from self.called(unit, place, called, is_call=True)
                given = [*node.args, *(each.value for each in node.keywords)] if not is_asking(called) else []
                inner = [one for each in given if isinstance(each, ast.List | ast.Tuple) for one in each.elts]
                for each in (*given, *inner):
                    yield from self.handed_on(unit, place, each, handed)
            case ast.Assign(targets=[ast.Attribute(value=value)], value=given) if ast.unparse(value) != "self":
                yield from self.handed_on(unit, place, given, handed)
            case ast.Name() | ast.Attribute() if id(node) not in handed:
                yield from self.named(unit, place, node)
            case ast.Import() | ast.ImportFrom():
                yield from self.imported(unit, node)
            case ast.withitem(context_expr=manager):
                for owner in self.objects.of(unit.file, manager):
                    yield from self.members(owner, "__enter__")
                    yield from self.members(owner, "__exit__")
            case ast.FunctionDef() | ast.AsyncFunctionDef() if self.is_registered(unit, node):
                yield Step(Own(unit.file, node))

    def handed_on(self, unit: Own, place: Place, node: ast.expr, handed: set[int]) -> Iterator[Step]:
        """Yield what a callback means that is given to something."""
        if isinstance(node, ast.Name | ast.Attribute):
            handed.add(id(node))
            yield from self.called(unit, place, node, is_call=False)

    def called(self, unit: Own, place: Place, node: ast.expr, *, is_call: bool) -> Iterator[Step]:
        """Yield what `name`, `module.name`, `self.name`, `super().name` or `object.name` means where it is called."""
        definition = place.inner.get(node.id) if isinstance(node, ast.Name) else None
        definition = definition or self.meanings.of(unit.file, node)
        if definition is not None:
            yield Step(definition)
        elif isinstance(node, ast.Name) and is_call:
            for each in self.objects.of(unit.file, node):
                yield from self.members(each, "__call__")
        elif isinstance(node, ast.Attribute):
            yield from self.of_object(unit, place, node, is_call=is_call)

    def of_object(self, unit: Own, place: Place, node: ast.Attribute, *, is_call: bool) -> Iterator[Step]:
        value, name = node.value, node.attr
        match value:
            case ast.Call(func=ast.Name(id="super")):
                found = self.objects.member(place.owner, name, above=True) if place.owner is not None else None
                yield from [Step(found)] if found is not None else []
                return
            case ast.Name(id="self" | "cls") if place.owner is not None:
                yield from self.of_self(place.owner, name)
                return
        definition = self.meanings.of(unit.file, value)
        owners = [definition] if definition is not None else self.objects.of(unit.file, value)
        for owner in owners:
            yield from self.members(owner, name)
        if is_call and not owners and not is_foreign(unit, value):
            for owner in self.objects.alone(name):
                yield Step(self.objects.members[owner.key, name], needs=owner)

    def of_self(self, owner: Own, name: str) -> Iterator[Step]:
        """Yield what `self.name` means: that of the class itself, unless each object is of an heir that replaces it."""
        found, heirs = self.objects.member(owner, name), self.objects.heirs.get(owner.key, ())
        if found is None or all(self.objects.member(each, name) == found for each in heirs):
            yield from self.members(owner, name)
            return
        for each in (owner, *heirs):
            definition = self.objects.member(each, name)
            yield from [Step(definition, needs=each, is_exact=True)] if definition is not None else []

    def members(self, owner: Own, name: str) -> Iterator[Step]:
        """Yield the function of a class, and those of its heirs of which there are objects."""
        found = self.objects.member(owner, name)
        yield from [Step(found)] if found is not None else []
        for heir in self.objects.heirs.get(owner.key, ()):
            other = self.objects.member(heir, name)
            if other is not None and other is not found:
                yield Step(other, needs=heir)

    def named(self, unit: Own, place: Place, node: ast.Name | ast.Attribute) -> Iterator[Step]:
        """Yield what a mention leads to: a property runs where it is read, a function where something takes it."""
        if isinstance(node.ctx, ast.Del):
            return
        for each in self.called(unit, place, node, is_call=False):
            if isinstance(each.to.node, FunctionNode) and is_property(each.to.node):
                yield each
            elif isinstance(node.ctx, ast.Load) and not isinstance(each.to.node, ast.Module):
                yield replace(each, more=1)

    def imported(self, unit: Own, node: ast.Import | ast.ImportFrom) -> Iterator[Step]:
        level = node.level if isinstance(node, ast.ImportFrom) else 0
        start = [node.module or ""] if isinstance(node, ast.ImportFrom) else [each.name for each in node.names]
        names = [
            *(".".join(each.split(".")[:end]) for each in start for end in range(1, len(each.split(".")) + 1)),
            *(f"{start[0]}.{each.name}".lstrip(".") for each in node.names if isinstance(node, ast.ImportFrom)),
        ]
        found = (self.meanings.module(unit.file, each, level) for each in dict.fromkeys(names))
        yield from (Step(each) for each in found if each is not None)

    def is_registered(self, unit: Own, node: FunctionNode) -> bool:
        """Return whether a decorator hands a function to an object that the file has made: `@app.route('/')`."""
        roots = {ast.unparse(each).partition("(")[0].partition(".")[0] for each in node.decorator_list}
        imported = {alias.asname or alias.name for each in unit.file.tree.body for alias in aliases(each)}
        is_of_object = any("." in ast.unparse(each).partition("(")[0] for each in node.decorator_list)
        return is_of_object and bool(roots - imported - {node.name}) and not is_property(node)


def aliases(node: ast.stmt) -> Sequence[ast.alias]:
    return node.names if isinstance(node, ast.Import | ast.ImportFrom) else ()


def is_asking(called: ast.expr) -> bool:
    return isinstance(called, ast.Name) and called.id in ASKING


def is_property(node: FunctionNode) -> bool:
    return any(ast.unparse(each).rpartition(".")[2] in PROPERTIES for each in node.decorator_list)


def is_foreign(unit: Own, value: ast.expr) -> bool:
    """Return whether an expression begins with what the file imports."""
    while isinstance(value, ast.Attribute | ast.Call | ast.Subscript):
        value = value.func if isinstance(value, ast.Call) else value.value
    names = {name for each in unit.file.imports for name in (*each.names, each.module.partition(".")[0])}
    return isinstance(value, ast.Name) and value.id in names
