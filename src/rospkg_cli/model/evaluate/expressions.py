"""Evaluate expressions."""

from __future__ import annotations

import ast
import builtins
from collections.abc import Callable, Iterator
from typing import Any

from ...source import Span
from .bounds import MAX_TEXT, LimitError
from .dict_methods import set_item
from .formatting import in_format
from .iteration import items_of, many
from .machine import Machine
from .methods import attribute, method
from .operators import binary, compared, sliced, subscript, truth
from .plain import NotPlainError, join, plain
from .values import (
    Argument,
    Attribute,
    Call,
    Class,
    Constant,
    Function,
    Kind,
    Mapping,
    Scope,
    Sequence,
    Symbol,
    Text,
    Unknown,
    Value,
)

BUILTINS = frozenset(dir(builtins))

DATA: dict[str, Callable[[Machine, Span], Value]] = {
    "os.sep": lambda machine, span: Text(span, "/"),
    "os.path.sep": lambda machine, span: Text(span, "/"),
    "os.linesep": lambda machine, span: Text(span, "\n"),
    "os.curdir": lambda machine, span: Text(span, "."),
    "os.pardir": lambda machine, span: Text(span, ".."),
    "sys.version_info": lambda machine, span: machine.unknown(span, "`sys.version_info` depends on the Python"),
    "sys.platform": lambda machine, span: machine.unknown(span, "`sys.platform` depends on the machine"),
    "sys.argv": lambda machine, span: machine.unknown(span, "`sys.argv` depends on the command"),
    "sys.path": lambda machine, span: machine.unknown(span, "`sys.path` depends on the environment"),
}
"""What a name of the standard library holds."""

MUTABLE = (Sequence, Mapping)


class Expressions(Machine):
    """Evaluates expressions; statements stand in a subclass."""

    def evaluate(self, node: ast.expr, scope: Scope) -> Value:
        """Return the value of an expression; raises LimitError."""
        self.tick()
        handler: Callable[[Any, Scope], Value] | None = getattr(self, f"on_{type(node).__name__}", None)
        if handler is not None:
            return handler(node, scope)
        return self.vague(node)

    def vague(self, node: ast.expr, *, options: tuple[Value, ...] = ()) -> Unknown:
        span = self.span(node)
        return self.unknown(span, f"{self.shown(span)} can't be evaluated", options=options)

    def otherwise(self, found: Value | None, node: ast.expr, *operands: Value) -> Value:
        """Return what was found, or the first reason why it could not be."""
        if found is not None:
            return found
        for each in operands:
            if isinstance(each, Unknown):
                return self.unknown(self.span(node), each.why)
        return self.vague(node)

    def on_Constant(self, node: ast.Constant, scope: Scope) -> Value:
        span = self.span(node)
        if not isinstance(node.value, str):
            return Constant(span, node.value)
        inner = Span(span.start, span.end)
        for size in (3, 1):
            quote = self.file.source.text[span.end - size : span.end]
            start = self.file.source.text.find(quote, span.start, span.start + 4)
            if quote and start >= 0 and self.file.source.text[start + size : span.end - size] == node.value:
                inner = Span(start + size, span.end - size)
                return Text(span, node.value, inner)
        return Text(span, node.value)

    def on_Name(self, node: ast.Name, scope: Scope) -> Value:
        found = scope.find(node.id)
        if found is not None:
            return found
        if node.id in BUILTINS:
            return Symbol(self.span(node), node.id)
        star = scope.top.find("*")
        if isinstance(star, Symbol):
            return Symbol(self.span(node), f"{star.name}.{node.id}")
        return self.unknown(self.span(node), f"`{node.id}` is not defined in this file")

    def on_Attribute(self, node: ast.Attribute, scope: Scope) -> Value:
        return self.member(self.evaluate(node.value, scope), node)

    def member(self, value: Value, node: ast.Attribute) -> Value:
        span = self.span(node)
        if isinstance(value, Symbol):
            name = f"{value.name}.{node.attr}"
            return DATA[name](self, span) if name in DATA else Symbol(span, name)
        if isinstance(value, Class):
            found = value.scope.names.get(node.attr)
            return self.vague(node) if found is None else found
        if isinstance(value, Unknown):
            return self.unknown(span, value.why)
        found = attribute(value, node.attr, Call(span, node.attr))
        if found is not None:
            return found
        self.doubts += 1
        return Attribute(span, value, node.attr)

    def on_BinOp(self, node: ast.BinOp, scope: Scope) -> Value:
        left, right = self.evaluate(node.left, scope), self.evaluate(node.right, scope)
        found = binary(type(node.op), left, right, self.span(node))
        if isinstance(found, Text) and len(found.text) > MAX_TEXT:
            raise LimitError(f"a text of more than {MAX_TEXT} characters")
        if isinstance(found, Sequence):
            self.tick(len(found.items))
        return self.otherwise(found, node, left, right)

    def on_UnaryOp(self, node: ast.UnaryOp, scope: Scope) -> Value:
        value, span = self.evaluate(node.operand, scope), self.span(node)
        if isinstance(node.op, ast.Not):
            verdict = truth(value)
            return self.otherwise(None, node, value) if verdict is None else Constant(span, not verdict)
        number = value.value if isinstance(value, Constant) else None
        if isinstance(number, int | float) and isinstance(node.op, ast.USub | ast.UAdd):
            return Constant(span, -number if isinstance(node.op, ast.USub) else number)
        return self.otherwise(None, node, value)

    def on_BoolOp(self, node: ast.BoolOp, scope: Scope) -> Value:
        stops = isinstance(node.op, ast.Or)
        options: list[Value] = []
        value: Value = Constant(self.span(node), None)
        for each in node.values:
            value = self.evaluate(each, scope)
            verdict = truth(value)
            if verdict is None:
                options.append(value)
            elif verdict is stops:
                break
        if not options or options == [value]:
            return value
        return self.vague(node, options=tuple(options if value in options else [*options, value]))

    def on_Compare(self, node: ast.Compare, scope: Scope) -> Value:
        left, told = self.evaluate(node.left, scope), True
        for kind, each in zip(node.ops, node.comparators, strict=True):
            right = self.evaluate(each, scope)
            verdict = compared(type(kind), left, right)
            if verdict is False:
                return Constant(self.span(node), False)
            told, left = told and verdict is True, right
        return Constant(self.span(node), True) if told else self.vague(node)

    def on_IfExp(self, node: ast.IfExp, scope: Scope) -> Value:
        verdict = truth(self.evaluate(node.test, scope))
        if verdict is not None:
            return self.evaluate(node.body if verdict else node.orelse, scope)
        with self.under(f"{self.shown(self.span(node.test))} can't be evaluated"):
            options = (self.evaluate(node.body, scope), self.evaluate(node.orelse, scope))
        return self.vague(node, options=options)

    def on_NamedExpr(self, node: ast.NamedExpr, scope: Scope) -> Value:
        value = self.evaluate(node.value, scope)
        scope.bind(node.target.id, value)
        return value

    # collections

    def on_List(self, node: ast.List | ast.Tuple | ast.Set, scope: Scope) -> Value:
        kind: Kind = "list" if isinstance(node, ast.List) else "tuple" if isinstance(node, ast.Tuple) else "set"
        result = Sequence(self.span(node), kind, display=True, born=len(self.conditions))
        for each in node.elts:
            if not isinstance(each, ast.Starred):
                self.put(result, self.evaluate(each, scope), self.span(each))
                continue
            value = self.evaluate(each.value, scope)
            items = items_of(self, value)
            if items is None:
                self.spoil(
                    result, self.span(each), getattr(value, "why", f"{self.shown(self.span(each))} can't be told")
                )
            for item in items or ():
                self.put(result, item, self.span(each))
        return result

    on_Tuple = on_Set = on_List

    def on_Dict(self, node: ast.Dict, scope: Scope) -> Value:
        result = Mapping(self.span(node), display=True, born=len(self.conditions))
        for key, item in zip(node.keys, node.values, strict=True):
            value = self.evaluate(item, scope)
            if key is not None:
                set_item(self, result, self.evaluate(key, scope), value, self.span(key))
            elif isinstance(value, Mapping):
                result.items.update(value.items)
                result.rest += value.rest
            else:
                self.spoil(result, self.span(item), f"{self.shown(self.span(item))} can't be evaluated")
        return result

    def on_Subscript(self, node: ast.Subscript, scope: Scope) -> Value:
        value = self.evaluate(node.value, scope)
        if not isinstance(node.slice, ast.Slice):
            index = self.evaluate(node.slice, scope)
            if isinstance(value, Symbol) and (known := self.library.get(f"{value.name}[]")) is not None:
                asked = Call(self.span(node), value.name, (Argument("", index, index.span),))
                return self.otherwise(known(self, asked), node, index)
            return self.otherwise(subscript(value, index, self.span(node)), node, value, index)
        try:
            ends = [
                None if n is None else plain(self.evaluate(n, scope))
                for n in (node.slice.lower, node.slice.upper, node.slice.step)
            ]
            return self.otherwise(sliced(value, slice(*ends), self.span(node)), node, value)
        except (NotPlainError, TypeError, ValueError):
            return self.vague(node)

    def on_JoinedStr(self, node: ast.JoinedStr, scope: Scope) -> Value:
        span, before = self.span(node), self.fixed
        self.fixed = span
        try:
            return join([self.piece(each, scope, span) for each in node.values], span)
        finally:
            self.fixed = before

    def piece(self, node: ast.expr, scope: Scope, span: Span) -> Value:
        if not isinstance(node, ast.FormattedValue):
            return self.evaluate(node, scope)
        value = self.evaluate(node.value, scope)
        spec = self.evaluate(node.format_spec, scope) if node.format_spec else Text(span, "")
        conversion = chr(node.conversion) if node.conversion > 0 else ""
        if not isinstance(spec, Text):
            return self.vague(node)
        return in_format(value, spec.text, conversion, span)

    # comprehensions

    def on_ListComp(self, node: ast.ListComp | ast.SetComp | ast.GeneratorExp, scope: Scope) -> Value:
        kind: Kind = "set" if isinstance(node, ast.SetComp) else "list"
        result = Sequence(self.span(node), kind, born=len(self.conditions))
        for inner in self.rounds(node.generators, Scope(scope)):
            self.put(result, self.evaluate(node.elt, inner), self.span(node.elt))
        return result

    on_SetComp = on_GeneratorExp = on_ListComp

    def on_DictComp(self, node: ast.DictComp, scope: Scope) -> Value:
        result = Mapping(self.span(node), born=len(self.conditions))
        for inner in self.rounds(node.generators, Scope(scope)):
            set_item(
                self, result, self.evaluate(node.key, inner), self.evaluate(node.value, inner), self.span(node.key)
            )
        return result

    def rounds(self, generators: list[ast.comprehension], scope: Scope) -> Iterator[Scope]:
        """Yield a scope for each round that a comprehension makes."""
        if not generators:
            yield scope
            return
        source = self.evaluate(generators[0].iter, scope)
        items = items_of(self, source)
        if items is None:
            why = getattr(source, "why", f"{self.shown(self.span(generators[0].iter))} can't be evaluated")
            items = [self.unknown(self.span(generators[0].iter), why, many=True)]
        for item in items:
            if isinstance(item, Unknown) and item.many:
                with self.under(item.why):
                    yield from self.round(generators, Unknown(item.span, item.why), scope)
            else:
                yield from self.round(generators, item, scope)

    def round(self, generators: list[ast.comprehension], item: Value, scope: Scope) -> Iterator[Scope]:
        inner = Scope(scope)
        self.assign(generators[0].target, item, inner)
        doubtful = ""
        for test in generators[0].ifs:
            verdict = truth(self.evaluate(test, inner))
            if verdict is False:
                return
            doubtful = doubtful or ("" if verdict else f"{self.shown(self.span(test))} can't be evaluated")
        if not doubtful:
            yield from self.rounds(generators[1:], inner)
            return
        with self.under(doubtful):
            yield from self.rounds(generators[1:], inner)

    def assign(self, target: ast.expr, value: Value, scope: Scope) -> None:
        """Bind what stands left of an `=`."""
        match target:
            case ast.Name():
                scope.bind(target.id, value)
            case ast.Tuple() | ast.List():
                self.unpack(target.elts, value, scope)
            case ast.Starred():
                self.assign(target.value, value, scope)
            case ast.Subscript():
                holder = self.evaluate(target.value, scope)
                if isinstance(holder, Mapping):
                    set_item(self, holder, self.evaluate(target.slice, scope), value, self.span(target))
                else:
                    self.spoil(holder, self.span(target), f"{self.shown(self.span(target))} can't be followed")

    def unpack(self, targets: list[ast.expr], value: Value, scope: Scope) -> None:
        items = items_of(self, value)
        plain_targets = not any(isinstance(target, ast.Starred) for target in targets)
        if items is None or any(map(many, items)) or not plain_targets or len(items) != len(targets):
            why = getattr(value, "why", "it can't be taken apart")
            items = [self.unknown(self.span(target), why) for target in targets]
        for target, item in zip(targets, items, strict=True):
            self.assign(target, item, scope)

    # functions

    def on_Lambda(self, node: ast.Lambda, scope: Scope) -> Value:
        return Function(self.span(node), "<lambda>", node, scope, self.defaults(node.args, scope))

    def defaults(self, arguments: ast.arguments, scope: Scope) -> dict[str, Value]:
        positional = [*arguments.posonlyargs, *arguments.args]
        pairs = list(zip(positional[len(positional) - len(arguments.defaults) :], arguments.defaults, strict=True))
        pairs += [(a, d) for a, d in zip(arguments.kwonlyargs, arguments.kw_defaults, strict=True) if d is not None]
        return {argument.arg: self.evaluate(default, scope) for argument, default in pairs}

    def on_Call(self, node: ast.Call, scope: Scope) -> Value:
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
        return self.leave(call, node, scope) if found is None else found

    def known_call(self, function: Value, receiver: Value | None, call: Call) -> Value | None:
        if receiver is not None:
            return method(self, receiver, call)
        if isinstance(function, Function):
            return None if function.decorated else self.run(function, call)
        if isinstance(function, Symbol) and function.name in self.library:
            if call.rest is not None:
                return None
            return self.library[function.name](self, call)
        return None

    def leave(self, call: Call, node: ast.Call, scope: Scope) -> Call:
        """Record a call that is not known; lists that it was handed by name may have been changed by it."""
        self.doubts += 1
        self.calls.append(call)
        last = call.callee.rpartition(".")[2]
        if last[:1].islower() and last != "setup":
            for each in [*node.args, *[keyword.value for keyword in node.keywords]]:
                handed = scope.find(each.id) if isinstance(each, ast.Name) else None
                if isinstance(handed, MUTABLE):
                    self.spoil(handed, call.span, f"{self.shown(call.span)} may change it")
        return call

    def arguments(self, node: ast.Call, scope: Scope) -> tuple[tuple[Argument, ...], Unknown | None]:
        found: list[Argument] = []
        rest: Unknown | None = None
        for each in node.args:
            if not isinstance(each, ast.Starred):
                found.append(Argument("", self.evaluate(each, scope), self.span(each)))
                continue
            value = self.evaluate(each.value, scope)
            items = items_of(self, value)
            if items is None or any(map(many, items)):
                rest = self.unknown(
                    self.span(each), getattr(value, "why", f"{self.shown(self.span(each))} can't be told")
                )
            found += [Argument("", item, self.span(each)) for item in items or () if not many(item)]
        for keyword in node.keywords:
            value = self.evaluate(keyword.value, scope)
            if keyword.arg is not None:
                found.append(Argument(keyword.arg, value, self.span(keyword)))
            elif isinstance(value, Mapping):
                found += [Argument(str(k), v, key.span) for k, (key, v) in value.items.items()]
                rest = value.rest[0] if value.rest else rest
            else:
                rest = self.unknown(
                    self.span(keyword), getattr(value, "why", f"{self.shown(self.span(keyword))} can't be told")
                )
        return tuple(found), rest

    def apply(self, function: Value, arguments: list[Value], span: Span) -> Value:
        name = function.name if isinstance(function, Symbol | Function) else ""
        call = Call(span, name, tuple(Argument("", value, span) for value in arguments), None, self.certain)
        found = self.known_call(function, None, call)
        return self.unknown(span, f"{self.shown(span)} can't be evaluated") if found is None else found

    def on_Starred(self, node: ast.Starred, scope: Scope) -> Value:
        return self.evaluate(node.value, scope)

    def on_Await(self, node: ast.Await, scope: Scope) -> Value:
        return self.evaluate(node.value, scope)

    def on_Yield(self, node: ast.Yield | ast.YieldFrom, scope: Scope) -> Value:
        yields = scope.yields
        value: Value = self.evaluate(node.value, scope) if node.value else Constant(self.span(node), None)
        if yields is not None and isinstance(node, ast.YieldFrom):
            for item in items_of(self, value) or [self.unknown(self.span(node), "it can't be told", many=True)]:
                self.put(yields, item, self.span(node))
        elif yields is not None:
            self.put(yields, value, self.span(node))
        return Constant(self.span(node), None)

    on_YieldFrom = on_Yield
