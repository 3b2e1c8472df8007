"""Functions and classes of the file: definition, binding of arguments, return value."""

from __future__ import annotations

import ast
from collections import deque
from functools import cached_property

from ....source import Span
from ..nodes import nodes_of
from .compound_statements import CompoundStatements
from .conversion import is_equal
from .dict_methods import set_item
from .limits import ITEM, MAX_CALLS, Flow, spend
from .values import Argument, Call, Class, Constant, Function, Mapping, Namespace, Sequence, Text, Value


class Functions(CompoundStatements):
    """Binds and runs functions."""

    depth = 0

    @cached_property
    def generators(self) -> dict[int, bool]:
        """By the `id` of a function's node, whether it yields."""
        return {}

    def do_FunctionDef(self, node: ast.FunctionDef | ast.AsyncFunctionDef, scope: Namespace) -> None:
        function = Function(self.span(node), node.name, node, scope, self.defaults(node.args, scope))
        function.is_decorated = bool(node.decorator_list)
        scope.bind(node.name, function)

    do_AsyncFunctionDef = do_FunctionDef

    def do_ClassDef(self, node: ast.ClassDef, scope: Namespace) -> None:
        inner = Namespace(scope)
        bases = tuple(self.evaluate(base, scope) for base in node.bases)
        self.execute(node.body, inner)
        scope.bind(node.name, Class(self.span(node), node.name, inner, bases))

    def run(self, function: Function, call: Call) -> Value:
        """Return what a function of the file returns for these arguments."""
        if self.depth >= MAX_CALLS:
            return self.unknown(call.span, f"`{function.name}` calls itself too deeply")
        scope = Namespace(function.scope)
        self.bind(function, call, scope)
        self.depth += 1
        try:
            if isinstance(function.node, ast.Lambda):
                return self.evaluate(function.node.body, scope)
            if self.is_generator(function.node):
                scope.yields = Sequence(call.span, "list", open_conditions=len(self.conditions))
            flow = self.execute(function.node.body, scope)
        finally:
            self.depth -= 1
        if scope.yields is not None:
            return scope.yields
        if flow in (Flow.NEXT, Flow.MAYBE):
            scope.returns.append(Constant(call.span, None))
        return self.return_value(function, scope.returns, call.span)

    def is_generator(self, node: ast.AST) -> bool:
        """Return whether a function contains `yield`; the answer is cached."""
        if "yield" not in self.file.source.text:
            return False
        if id(node) not in self.generators:
            self.generators[id(node)] = any(isinstance(each, ast.Yield | ast.YieldFrom) for each in nodes_of(node))
        return self.generators[id(node)]

    def return_value(self, function: Function, returns: list[Value], span: Span) -> Value:
        if not returns:
            return self.unknown(span, f"`{function.name}` raises")
        if all(is_equal(returns[0], other) for other in returns[1:]):
            return returns[0]
        return self.unknown(span, f"what `{function.name}` returns is unknown", options=tuple(returns))

    def bind(self, function: Function, call: Call, scope: Namespace) -> None:
        """Give the parameters their values."""
        arguments, left = function.node.args, deque(call.positional)
        named = {argument.name: argument for argument in call.arguments if argument.name}
        keywords = set(map(id, arguments.kwonlyargs))
        spend(len(call.arguments) * ITEM)
        for parameter in [*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs]:
            keyword_only = id(parameter) in keywords
            if left and not keyword_only:
                value: Value = left.popleft()
            elif parameter.arg in named:
                value = named.pop(parameter.arg).value
            elif parameter.arg in function.defaults and call.rest is None:
                value = function.defaults[parameter.arg]
            else:
                value = self.unknown(call.span, f"`{parameter.arg}` is not given")
            scope.names[parameter.arg] = value
        if arguments.vararg:
            scope.names[arguments.vararg.arg] = self.rest_arguments(list(left), call)
        if arguments.kwarg:
            scope.names[arguments.kwarg.arg] = self.rest_keywords(list(named.values()), call)

    def rest_arguments(self, values: list[Value], call: Call) -> Value:
        result = Sequence(call.span, "tuple", values, [call.span] * len(values), open_conditions=len(self.conditions))
        if call.rest is not None:
            self.mark_unknown(result, call.span, call.rest.why)
        return result

    def rest_keywords(self, arguments: list[Argument], call: Call) -> Value:
        result = Mapping(call.span, open_conditions=len(self.conditions))
        for argument in arguments:
            set_item(self, result, Text(argument.span, argument.name), argument.value, argument.span)
        if call.rest is not None:
            self.mark_unknown(result, call.span, call.rest.why)
        return result
