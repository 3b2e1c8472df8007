"""Evaluate displays, subscripts and comprehensions; assign to targets."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from .conversion import NoPythonValueError, to_python
from .dict_methods import merge, set_item
from .expressions import Expressions
from .iterables import is_many, items_of
from .list_methods import put_item
from .operators import slice_of, subscript
from .truthiness import truth
from .values import (
    Argument,
    Call,
    Kind,
    Mapping,
    Namespace,
    Sequence,
    Symbol,
    Unknown,
    Value,
)


class Containers(Expressions):
    """Evaluates expressions that build or unpack containers."""

    def on_List(self, node: ast.List | ast.Tuple | ast.Set, scope: Namespace) -> Value:
        kind: Kind = "list" if isinstance(node, ast.List) else "tuple" if isinstance(node, ast.Tuple) else "set"
        result = Sequence(self.span(node), kind, is_display=True, open_conditions=len(self.conditions))
        for each in node.elts:
            if not isinstance(each, ast.Starred):
                self.add_item(result, self.evaluate(each, scope), self.span(each))
                continue
            value = self.evaluate(each.value, scope)
            items = items_of(self, value)
            if items is None:
                self.mark_unknown(
                    result, self.span(each), getattr(value, "why", f"{self.quoted(self.span(each))} can't be evaluated")
                )
            for item in items or ():
                self.add_item(result, item, self.span(each))
        return result

    on_Tuple = on_Set = on_List

    def on_Dict(self, node: ast.Dict, scope: Namespace) -> Value:
        result = Mapping(self.span(node), is_display=True, open_conditions=len(self.conditions))
        for key, item in zip(node.keys, node.values, strict=True):
            value = self.evaluate(item, scope)
            if key is not None:
                set_item(self, result, self.evaluate(key, scope), value, self.span(key))
            elif isinstance(value, Mapping):
                merge(result, value)
            else:
                self.mark_unknown(result, self.span(item), f"{self.quoted(self.span(item))} can't be evaluated")
        return result

    def on_Subscript(self, node: ast.Subscript, scope: Namespace) -> Value:
        value = self.evaluate(node.value, scope)
        if not isinstance(node.slice, ast.Slice):
            index = self.evaluate(node.slice, scope)
            if isinstance(value, Symbol) and (known := self.library.get(f"{value.name}[]")) is not None:
                asked = Call(self.span(node), value.name, (Argument("", index, index.span),))
                return self.or_unknown(known(self, asked), node, index)
            return self.or_unknown(subscript(value, index, self.span(node)), node, value, index)
        try:
            ends = [
                None if n is None else to_python(self.evaluate(n, scope))
                for n in (node.slice.lower, node.slice.upper, node.slice.step)
            ]
            return self.or_unknown(slice_of(value, slice(*ends), self.span(node)), node, value)
        except (NoPythonValueError, TypeError, ValueError):
            return self.unknown_expression(node)

    def on_ListComp(self, node: ast.ListComp | ast.SetComp | ast.GeneratorExp, scope: Namespace) -> Value:
        kind: Kind = "set" if isinstance(node, ast.SetComp) else "list"
        result = Sequence(self.span(node), kind, open_conditions=len(self.conditions))
        for inner in self.iterations(node.generators, Namespace(scope)):
            self.add_item(result, self.evaluate(node.elt, inner), self.span(node.elt))
        return result

    on_SetComp = on_GeneratorExp = on_ListComp

    def on_DictComp(self, node: ast.DictComp, scope: Namespace) -> Value:
        result = Mapping(self.span(node), open_conditions=len(self.conditions))
        for inner in self.iterations(node.generators, Namespace(scope)):
            set_item(
                self, result, self.evaluate(node.key, inner), self.evaluate(node.value, inner), self.span(node.key)
            )
        return result

    def iterations(self, generators: list[ast.comprehension], scope: Namespace) -> Iterator[Namespace]:
        """Yield a scope for each iteration of a comprehension."""
        if not generators:
            yield scope
            return
        source = self.evaluate(generators[0].iter, scope)
        items = items_of(self, source)
        if items is None:
            why = getattr(source, "why", f"{self.quoted(self.span(generators[0].iter))} can't be evaluated")
            items = [self.unknown(self.span(generators[0].iter), why, many=True)]
        for item in items:
            if isinstance(item, Unknown) and item.is_many:
                with self.assuming(item.why):
                    yield from self.iteration(generators, Unknown(item.span, item.why), scope)
            else:
                yield from self.iteration(generators, item, scope)

    def iteration(self, generators: list[ast.comprehension], item: Value, scope: Namespace) -> Iterator[Namespace]:
        inner = Namespace(scope)
        self.assign(generators[0].target, item, inner)
        doubtful = ""
        for test in generators[0].ifs:
            verdict = truth(self.evaluate(test, inner))
            if verdict is False:
                return
            doubtful = doubtful or ("" if verdict else f"{self.quoted(self.span(test))} can't be evaluated")
        if not doubtful:
            yield from self.iterations(generators[1:], inner)
            return
        with self.assuming(doubtful):
            yield from self.iterations(generators[1:], inner)

    def assign(self, target: ast.expr, value: Value, scope: Namespace) -> None:
        """Bind a target, the left side of an `=`."""
        match target:
            case ast.Name(id=name):
                if name in scope.outer and not self.certain:  # of a scope that no branch puts back
                    old = scope.find(name)
                    value = self.unknown(
                        self.span(target), self.conditions[-1], options=(*([old] if old else ()), value)
                    )
                scope.bind(name, value)
            case ast.Tuple() | ast.List():
                self.unpack(target.elts, value, scope)
            case ast.Starred():
                self.assign(target.value, value, scope)
            case ast.Subscript():
                holder = self.evaluate(target.value, scope)
                if isinstance(holder, Mapping):
                    set_item(self, holder, self.evaluate(target.slice, scope), value, self.span(target))
                elif isinstance(holder, Sequence):
                    put_item(self, holder, self.index(target.slice, scope), value, self.span(target))
                else:
                    self.mark_unknown(holder, self.span(target), f"{self.quoted(self.span(target))} can't be followed")

    def index(self, node: ast.expr, scope: Namespace) -> Value | None:
        """Return the index that a subscript asks for; None for a slice."""
        return None if isinstance(node, ast.Slice) else self.evaluate(node, scope)

    def unpack(self, targets: list[ast.expr], value: Value, scope: Namespace) -> None:
        items = items_of(self, value)
        plain_targets = not any(isinstance(target, ast.Starred) for target in targets)
        if items is None or any(map(is_many, items)) or not plain_targets or len(items) != len(targets):
            why = getattr(value, "why", "it can't be taken apart")
            items = [self.unknown(self.span(target), why) for target in targets]
        for target, item in zip(targets, items, strict=True):
            self.assign(target, item, scope)
