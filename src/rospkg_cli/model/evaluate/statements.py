"""Execute statements: what happens for certain, and what perhaps happens."""

from __future__ import annotations

import ast
import sys
from collections.abc import Callable
from typing import Any

from ...source import Span
from .bounds import MAX_CALLS, Flow
from .dict_methods import set_item
from .expressions import Expressions
from .iteration import items_of
from .list_methods import extend_by
from .operators import binary, truth
from .plain import same
from .values import Argument, Call, Class, Constant, Function, Mapping, Scope, Sequence, Symbol, Text, Unknown, Value

ALWAYS_THERE = sys.stdlib_module_names | {"setuptools"}
"""What can be imported wherever a setup.py runs."""

EXITS = frozenset({"sys.exit", "exit", "quit", "os._exit"})


class Statements(Expressions):
    depth = 0

    def execute(self, body: list[ast.stmt], scope: Scope) -> Flow:
        """Run statements one after the other; raises LimitError."""
        for index, node in enumerate(body):
            self.tick()
            handler: Callable[[Any, Scope], Flow | None] | None = getattr(self, f"do_{type(node).__name__}", None)
            flow = (handler(node, scope) if handler else self.do_unknown(node, scope)) or Flow.NEXT
            if flow is Flow.MAYBE:
                self.branch([body[index + 1 :]], scope, f"{self.shown(self.span(node))} may leave early")
            if flow is not Flow.NEXT:
                return flow
        return Flow.NEXT

    def do_unknown(self, node: ast.stmt, scope: Scope) -> Flow | None:
        """A statement that has no method here: whatever names it binds are unknown from here on."""
        for each in ast.walk(node):
            if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store):
                scope.bind(each.id, self.unknown(self.span(each), f"{self.shown(self.span(node))} can't be evaluated"))
        return None

    def branch(self, bodies: list[list[ast.stmt]], scope: Scope, why: str) -> Flow:
        """Run alternatives of which one may happen (perhaps none), and join what they leave behind."""
        before, ends, flows = dict(scope.names), [], []
        for body in bodies:
            scope.names = dict(before)
            with self.under(why):
                flows.append(self.execute(body, scope))
            if flows[-1] in (Flow.NEXT, Flow.MAYBE):
                ends.append(scope.names)
        if len(bodies) == 1:
            ends.append(before)
            flows.append(Flow.NEXT)
        scope.names = self.joined(ends or [before], why)
        leaves = {flow for flow in flows if flow is not Flow.RAISE}
        if not leaves:
            return Flow.RAISE
        return leaves.pop() if len(leaves) == 1 else Flow.MAYBE

    def joined(self, ends: list[dict[str, Value]], why: str) -> dict[str, Value]:
        result = dict(ends[0])
        for end in ends[1:]:
            for name in [*result, *[name for name in end if name not in result]]:
                result[name] = self.either(result.get(name), end.get(name), why)
        return result

    def either(self, a: Value | None, b: Value | None, why: str) -> Value:
        """Return a value that stands for one of two; where one of them was imported, that one is meant."""
        if a is None or b is None:
            found = b if a is None else a
            assert found is not None
            return (
                found
                if isinstance(found, Symbol | Function | Class)
                else self.unknown(found.span, why, options=(found,))
            )
        if same(a, b) or isinstance(a, Symbol):
            return a
        if isinstance(b, Symbol):
            return b
        return self.unknown(a.span, why, options=(a, b))

    # simple statements

    def do_Expr(self, node: ast.Expr, scope: Scope) -> Flow | None:
        if isinstance(node.value, ast.Call):
            function = self.evaluate(node.value.func, scope) if isinstance(node.value.func, ast.Name) else None
            name = function.name if isinstance(function, Symbol) else ast.unparse(node.value.func)[:20]
            if name in EXITS:
                return Flow.RAISE
        self.evaluate(node.value, scope)
        return None

    def do_Assign(self, node: ast.Assign, scope: Scope) -> None:
        value = self.evaluate(node.value, scope)
        for target in node.targets:
            self.assign(target, value, scope)

    def do_AnnAssign(self, node: ast.AnnAssign, scope: Scope) -> None:
        if node.value is not None:
            self.assign(node.target, self.evaluate(node.value, scope), scope)

    def do_AugAssign(self, node: ast.AugAssign, scope: Scope) -> None:
        target = node.target
        old = self.evaluate(ast.copy_location(as_load(target), target), scope)
        value = self.evaluate(node.value, scope)
        if isinstance(old, Sequence) and old.kind != "tuple" and isinstance(node.op, ast.Add | ast.BitOr):
            extend_by(self, old, value, Call(self.span(node), "+="))
            return
        found = binary(type(node.op), old, value, self.span(node))
        self.assign(target, self.otherwise(found, node.value, old, value), scope)

    def do_Delete(self, node: ast.Delete, scope: Scope) -> None:
        for target in node.targets:
            if isinstance(target, ast.Name):
                scope.names.pop(target.id, None)
            elif isinstance(target, ast.Subscript):
                holder = self.evaluate(target.value, scope)
                self.spoil(holder, self.span(node), f"{self.shown(self.span(node))} can't be followed")

    def do_Return(self, node: ast.Return, scope: Scope) -> Flow:
        value = self.evaluate(node.value, scope) if node.value else Constant(self.span(node), None)
        scope.returns.append(value)
        return Flow.RETURN

    def do_Raise(self, node: ast.Raise, scope: Scope) -> Flow:
        return Flow.RAISE

    def do_Break(self, node: ast.Break, scope: Scope) -> Flow:
        return Flow.BREAK

    def do_Continue(self, node: ast.Continue, scope: Scope) -> Flow:
        return Flow.CONTINUE

    def do_Pass(self, node: ast.Pass, scope: Scope) -> None:
        """Nothing happens."""

    def do_Assert(self, node: ast.Assert, scope: Scope) -> None:
        """It holds, or nothing after it matters."""

    def do_Global(self, node: ast.Global | ast.Nonlocal, scope: Scope) -> None:
        for name in node.names:
            at: Scope | None = scope.parent if isinstance(node, ast.Nonlocal) else scope.top
            while isinstance(node, ast.Nonlocal) and at is not None and name not in at.names:
                at = at.parent
            scope.outer[name] = at or scope.top

    do_Nonlocal = do_Global

    def do_Import(self, node: ast.Import, scope: Scope) -> None:
        for alias in node.names:
            self.doubt_import(alias.name)
            bound = alias.name if alias.asname else alias.name.partition(".")[0]
            scope.bind(alias.asname or bound, Symbol(self.span(alias), bound))

    def do_ImportFrom(self, node: ast.ImportFrom, scope: Scope) -> None:
        module = "." * node.level + (node.module or "")
        self.doubt_import(module)
        for alias in node.names:
            if alias.name == "*":
                scope.bind("*", Symbol(self.span(alias), module))
            else:
                between = "" if module.endswith(".") else "."
                scope.bind(alias.asname or alias.name, Symbol(self.span(alias), f"{module}{between}{alias.name}"))

    def doubt_import(self, module: str) -> None:
        if module.partition(".")[0] not in ALWAYS_THERE:
            self.doubts += 1

    def do_If(self, node: ast.If, scope: Scope) -> Flow:
        verdict = truth(self.evaluate(node.test, scope))
        if verdict is not None:
            return self.execute(node.body if verdict else node.orelse, scope)
        why = f"{self.shown(self.span(node.test))} can't be evaluated"
        return self.branch([node.body, node.orelse], scope, why)

    def do_For(self, node: ast.For | ast.AsyncFor, scope: Scope) -> Flow | None:
        source = self.evaluate(node.iter, scope)
        items, span = items_of(self, source), self.span(node.iter)
        if items is None:
            items = [self.unknown(span, getattr(source, "why", f"{self.shown(span)} can't be evaluated"), many=True)]
        for index, item in enumerate(items):
            perhaps = isinstance(item, Unknown) and item.many
            if isinstance(item, Unknown) and item.many:
                self.assign(node.target, Unknown(item.span, item.why), scope)
                flow = self.branch([node.body], scope, item.why)
            else:
                self.assign(node.target, item, scope)
                flow = self.execute(node.body, scope)
            if flow in (Flow.RETURN, Flow.RAISE) and not perhaps:
                return flow
            if flow is Flow.BREAK and not perhaps:
                return None
            if flow is Flow.MAYBE and has_break(node):
                return self.rest_of_loop(node, items[index + 1 :], scope)
        return self.execute(node.orelse, scope)

    def rest_of_loop(self, node: ast.For | ast.AsyncFor, items: list[Value], scope: Scope) -> Flow:
        """Run the rounds after one that perhaps was the last."""
        why = f"{self.shown(self.span(node.iter))} may end early"
        for item in items:
            self.assign(node.target, item, scope)
            self.branch([node.body], scope, why)
        return Flow.MAYBE if any(isinstance(each, ast.Return) for each in ast.walk(node)) else Flow.NEXT

    do_AsyncFor = do_For

    def do_While(self, node: ast.While, scope: Scope) -> Flow | None:
        while True:
            verdict = truth(self.evaluate(node.test, scope))
            if verdict is None:
                self.branch([node.body], scope, f"{self.shown(self.span(node.test))} can't be evaluated")
                return self.do_unknown(node, scope)
            if not verdict:
                return self.execute(node.orelse, scope)
            flow = self.execute(node.body, scope)
            if flow in (Flow.RETURN, Flow.RAISE):
                return flow
            if flow is Flow.BREAK:
                return None
            if flow is Flow.MAYBE:
                return self.do_unknown(node, scope)

    def do_Try(self, node: ast.Try, scope: Scope) -> Flow:
        before, doubts = dict(scope.names), self.doubts
        flow = self.execute(node.body, scope)
        raises = flow is Flow.RAISE or self.doubts > doubts
        if flow is Flow.NEXT:
            flow = self.execute(node.orelse, scope)
        if raises and node.handlers:
            ends = [] if flow is Flow.RAISE else [scope.names]
            for handler in node.handlers:
                scope.names = dict(before)
                if handler.name:
                    scope.bind(handler.name, self.unknown(self.span(handler), "it depends on what is raised"))
                with self.under("it can't be told whether an exception is raised"):
                    if self.execute(handler.body, scope) in (Flow.NEXT, Flow.MAYBE):
                        ends.append(scope.names)
            scope.names = self.joined(ends or [before], "it can't be told whether an exception is raised")
            flow = flow if flow is not Flow.RAISE else Flow.NEXT
        final = self.execute(node.finalbody, scope)
        return flow if final is Flow.NEXT else final

    do_TryStar = do_Try

    def do_With(self, node: ast.With | ast.AsyncWith, scope: Scope) -> Flow:
        for item in node.items:
            value = self.evaluate(item.context_expr, scope)
            if item.optional_vars is not None:
                self.assign(item.optional_vars, value, scope)
        return self.execute(node.body, scope)

    do_AsyncWith = do_With

    def do_Match(self, node: ast.Match, scope: Scope) -> Flow:
        self.evaluate(node.subject, scope)
        why = f"{self.shown(self.span(node.subject))} is not matched here"
        return self.branch([*[case.body for case in node.cases], []], scope, why)

    # classes and functions: they only bind a name

    def do_FunctionDef(self, node: ast.FunctionDef | ast.AsyncFunctionDef, scope: Scope) -> None:
        function = Function(self.span(node), node.name, node, scope, self.defaults(node.args, scope))
        function.decorated = bool(node.decorator_list)
        scope.bind(node.name, function)

    do_AsyncFunctionDef = do_FunctionDef

    def do_ClassDef(self, node: ast.ClassDef, scope: Scope) -> None:
        inner = Scope(scope)
        bases = tuple(self.evaluate(base, scope) for base in node.bases)
        self.execute(node.body, inner)
        scope.bind(node.name, Class(self.span(node), node.name, inner, bases))

    def run(self, function: Function, call: Call) -> Value:
        """Return what a function of the file returns for these arguments."""
        if self.depth >= MAX_CALLS:
            return self.unknown(call.span, f"`{function.name}` calls itself too deeply")
        scope = Scope(function.scope)
        self.bind(function, call, scope)
        self.depth += 1
        try:
            if isinstance(function.node, ast.Lambda):
                return self.evaluate(function.node.body, scope)
            if any(isinstance(each, ast.Yield | ast.YieldFrom) for each in ast.walk(function.node)):
                scope.yields = Sequence(call.span, "list", born=len(self.conditions))
            flow = self.execute(function.node.body, scope)
        finally:
            self.depth -= 1
        if scope.yields is not None:
            return scope.yields
        if flow in (Flow.NEXT, Flow.MAYBE):
            scope.returns.append(Constant(call.span, None))
        return self.returned(function, scope.returns, call.span)

    def returned(self, function: Function, returns: list[Value], span: Span) -> Value:
        if not returns:
            return self.unknown(span, f"`{function.name}` raises")
        if all(same(returns[0], other) for other in returns[1:]):
            return returns[0]
        return self.unknown(span, f"what `{function.name}` returns can't be told", options=tuple(returns))

    def bind(self, function: Function, call: Call, scope: Scope) -> None:
        """Give the parameters their values."""
        arguments, left = function.node.args, list(call.positional)
        named = {argument.name: argument for argument in call.arguments if argument.name}
        for parameter in [*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs]:
            keyword_only = parameter in arguments.kwonlyargs
            if left and not keyword_only:
                value: Value = left.pop(0)
            elif parameter.arg in named:
                value = named.pop(parameter.arg).value
            elif parameter.arg in function.defaults and call.rest is None:
                value = function.defaults[parameter.arg]
            else:
                value = self.unknown(call.span, f"`{parameter.arg}` is not given")
            scope.names[parameter.arg] = value
        if arguments.vararg:
            scope.names[arguments.vararg.arg] = self.gathered(left, call)
        if arguments.kwarg:
            scope.names[arguments.kwarg.arg] = self.gathered_names(list(named.values()), call)

    def gathered(self, values: list[Value], call: Call) -> Value:
        result = Sequence(call.span, "tuple", values, [call.span] * len(values), born=len(self.conditions))
        if call.rest is not None:
            self.spoil(result, call.span, call.rest.why)
        return result

    def gathered_names(self, arguments: list[Argument], call: Call) -> Value:
        result = Mapping(call.span, born=len(self.conditions))
        for argument in arguments:
            set_item(self, result, Text(argument.span, argument.name), argument.value, argument.span)
        if call.rest is not None:
            self.spoil(result, call.span, call.rest.why)
        return result


def as_load(target: ast.expr) -> ast.expr:
    """Return the expression that reads what a target writes."""
    match target:
        case ast.Name():
            return ast.Name(target.id, ast.Load())
        case ast.Attribute():
            return ast.Attribute(target.value, target.attr, ast.Load())
        case ast.Subscript():
            return ast.Subscript(target.value, target.slice, ast.Load())
    return target


def has_break(node: ast.For | ast.AsyncFor) -> bool:
    return any(isinstance(each, ast.Break | ast.Return) for each in ast.walk(node))
