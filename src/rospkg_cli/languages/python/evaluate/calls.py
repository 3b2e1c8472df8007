"""Evaluate calls: of known functions and functions of the file; other calls are recorded."""

from __future__ import annotations

import ast

from ....source import Span
from ..nodes import defaults_of
from .containers import Containers
from .iterables import is_many, items_of
from .methods import call_method
from .operators import certainly
from .values import (
    Argument,
    Call,
    Class,
    Constant,
    Function,
    Mapping,
    Namespace,
    Sequence,
    Symbol,
    Unknown,
    Value,
)

MUTABLE = (Sequence, Mapping)


class Calls(Containers):
    """Evaluates calls; functions of the file are run by a subclass."""

    def on_Lambda(self, node: ast.Lambda, scope: Namespace) -> Value:
        return Function(self.span(node), "<lambda>", node, scope, self.defaults(node.args, scope))

    def defaults(self, arguments: ast.arguments, scope: Namespace) -> dict[str, Value]:
        return {argument.arg: self.evaluate(default, scope) for argument, default in defaults_of(arguments)}

    def on_Call(self, node: ast.Call, scope: Namespace) -> Value:
        receiver: Value | None = None
        function: Value
        if isinstance(node.func, ast.Attribute):
            receiver = self.evaluate(node.func.value, scope)
            if isinstance(receiver, Symbol | Class):
                function, receiver = self.member(receiver, node.func), None
            else:
                function = Symbol(self.span(node.func), node.func.attr)
        else:
            function = self.evaluate(node.func, scope)
        arguments, rest = self.arguments(node, scope)
        name = function.name if isinstance(function, Symbol | Function | Class) else ""
        call = Call(self.span(node), name, arguments, receiver, self.certain, rest)
        found = self.known_call(function, receiver, call)
        return self.record_call(call, node, scope) if found is None else found

    def known_call(self, function: Value, receiver: Value | None, call: Call) -> Value | None:
        if receiver is not None:
            return call_method(self, receiver, call)
        if isinstance(function, Function):
            return None if function.is_decorated else self.run(function, call)
        if isinstance(function, Symbol) and function.name in self.library:
            if call.rest is not None:
                return None
            return self.library[function.name](self, call)
        return None

    def record_call(self, call: Call, node: ast.Call, scope: Namespace) -> Call:
        """Record a call of an unknown function; it may have changed lists and dicts that are passed by name."""
        self.unknown_count += 1
        self.calls.append(call)
        last = call.callee.rpartition(".")[2]
        if last[:1].islower() and last != "setup":
            for each in [*node.args, *[keyword.value for keyword in node.keywords]]:
                passed = scope.find(each.id) if isinstance(each, ast.Name) else None
                if isinstance(passed, MUTABLE):
                    self.mark_unknown(passed, call.span, f"{self.quoted(call.span)} may change it")
        return call

    def arguments(self, node: ast.Call, scope: Namespace) -> tuple[tuple[Argument, ...], Unknown | None]:
        found: list[Argument] = []
        rest: Unknown | None = None
        for each in node.args:
            if not isinstance(each, ast.Starred):
                value = self.evaluate(each, scope)
                # behind `*x` of unknown length nobody knows which parameter a value is for
                value = value if rest is None else self.unknown(self.span(each), rest.why)
                found.append(Argument("", value, self.span(each)))
                continue
            value = self.evaluate(each.value, scope)
            items = items_of(self, value)
            if items is None or any(map(is_many, items)):
                rest = self.unknown(
                    self.span(each), getattr(value, "why", f"{self.quoted(self.span(each))} can't be evaluated")
                )
            self.tick(len(items or ()))
            found += [Argument("", item, self.span(each)) for item in items or () if not is_many(item)]
        for keyword in node.keywords:
            value = self.evaluate(keyword.value, scope)
            if keyword.arg is not None:
                found.append(Argument(keyword.arg, value, self.span(keyword)))
            elif isinstance(value, Mapping):
                found += [Argument(str(k), certainly(v), key.span) for k, (key, v) in value.items.items()]
                perhaps = (v for _, v in value.items.values() if isinstance(v, Unknown) and v.is_many)
                rest = next(iter((*value.rest, *perhaps)), rest)
            else:
                rest = self.unknown(
                    self.span(keyword), getattr(value, "why", f"{self.quoted(self.span(keyword))} can't be evaluated")
                )
        return tuple(found), rest

    def apply(self, function: Value, arguments: list[Value], span: Span) -> Value:
        self.tick()
        name = function.name if isinstance(function, Symbol | Function) else ""
        call = Call(span, name, tuple(Argument("", value, span) for value in arguments), None, self.certain)
        found = self.known_call(function, None, call)
        return self.unknown(span, f"{self.quoted(span)} can't be evaluated") if found is None else found

    def on_Starred(self, node: ast.Starred, scope: Namespace) -> Value:
        return self.evaluate(node.value, scope)

    def on_Await(self, node: ast.Await, scope: Namespace) -> Value:
        return self.evaluate(node.value, scope)

    def on_Yield(self, node: ast.Yield | ast.YieldFrom, scope: Namespace) -> Value:
        yields = scope.yields
        value: Value = self.evaluate(node.value, scope) if node.value else Constant(self.span(node), None)
        if yields is not None and isinstance(node, ast.YieldFrom):
            for item in items_of(self, value) or [self.unknown(self.span(node), "it can't be evaluated", many=True)]:
                self.add_item(yields, item, self.span(node))
        elif yields is not None:
            self.add_item(yields, value, self.span(node))
        return Constant(self.span(node), None)

    on_YieldFrom = on_Yield
