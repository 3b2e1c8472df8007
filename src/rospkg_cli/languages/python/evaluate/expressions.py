"""Evaluate expressions."""

from __future__ import annotations

import ast
import builtins
from collections.abc import Callable
from typing import Any

from ....source import Span
from .conversion import join_texts
from .formatting import format_value
from .methods import path_attribute
from .operators import binary_operation
from .state import EvaluationState
from .truthiness import compare, truth
from .values import (
    AttributeValue,
    Call,
    Class,
    Constant,
    Namespace,
    Symbol,
    Text,
    Unknown,
    Value,
)

BUILTINS = frozenset(dir(builtins))

DATA: dict[str, Callable[[EvaluationState, Span], Value]] = {
    "os.sep": lambda state, span: Text(span, "/"),
    "os.path.sep": lambda state, span: Text(span, "/"),
    "os.linesep": lambda state, span: Text(span, "\n"),
    "os.curdir": lambda state, span: Text(span, "."),
    "os.pardir": lambda state, span: Text(span, ".."),
    "sys.version_info": lambda state, span: state.unknown(span, "`sys.version_info` depends on the Python"),
    "sys.platform": lambda state, span: state.unknown(span, "`sys.platform` depends on the machine"),
    "sys.argv": lambda state, span: state.unknown(span, "`sys.argv` depends on the command"),
    "sys.path": lambda state, span: state.unknown(span, "`sys.path` depends on the environment"),
}
"""What a name of the standard library holds."""


class Expressions(EvaluationState):
    """Evaluates expressions; a subclass executes statements."""

    def evaluate(self, node: ast.expr, scope: Namespace) -> Value:
        """Return the value of an expression; raises LimitError."""
        self.tick()
        handler: Callable[[Any, Namespace], Value] | None = getattr(self, f"on_{type(node).__name__}", None)
        if handler is not None:
            return handler(node, scope)
        return self.unknown_expression(node)

    def on_operands(self, node: ast.expr, *operands: Value) -> None:
        """Called with the operands of an operator or an f-string; a hook for subclasses."""

    def unknown_expression(self, node: ast.expr, *, options: tuple[Value, ...] = ()) -> Unknown:
        span = self.span(node)
        return self.unknown(span, f"{self.quoted(span)} can't be evaluated", options=options)

    def or_unknown(self, found: Value | None, node: ast.expr, *operands: Value) -> Value:
        """Return what was found, else an Unknown with the first reason among the operands."""
        if found is not None:
            return found
        for each in operands:
            if isinstance(each, Unknown):
                return self.unknown(self.span(node), each.why)
        return self.unknown_expression(node)

    def on_Constant(self, node: ast.Constant, scope: Namespace) -> Value:
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

    def on_Name(self, node: ast.Name, scope: Namespace) -> Value:
        found = scope.find(node.id)
        if found is not None:
            return found
        if node.id in BUILTINS:
            return Symbol(self.span(node), node.id)
        star = scope.top.find("*")
        if isinstance(star, Symbol):
            return Symbol(self.span(node), f"{star.name}.{node.id}")
        return self.unknown(self.span(node), f"`{node.id}` is not defined in this file")

    def on_Attribute(self, node: ast.Attribute, scope: Namespace) -> Value:
        return self.member(self.evaluate(node.value, scope), node)

    def member(self, value: Value, node: ast.Attribute) -> Value:
        span = self.span(node)
        if isinstance(value, Symbol):
            name = f"{value.name}.{node.attr}"
            return DATA[name](self, span) if name in DATA else Symbol(span, name)
        if isinstance(value, Class):
            found = value.scope.names.get(node.attr)
            return self.unknown_expression(node) if found is None else found
        if isinstance(value, Unknown):
            return self.unknown(span, value.why)
        found = path_attribute(value, node.attr, Call(span, node.attr))
        if found is not None:
            return found
        self.unknown_count += 1
        return AttributeValue(span, value, node.attr)

    def on_BinOp(self, node: ast.BinOp, scope: Namespace) -> Value:
        left, right = self.evaluate(node.left, scope), self.evaluate(node.right, scope)
        self.on_operands(node, left, right)
        found = binary_operation(type(node.op), left, right, self.span(node))
        return self.or_unknown(found, node, left, right)

    def on_UnaryOp(self, node: ast.UnaryOp, scope: Namespace) -> Value:
        value, span = self.evaluate(node.operand, scope), self.span(node)
        self.on_operands(node, value)
        if isinstance(node.op, ast.Not):
            verdict = truth(value)
            return self.or_unknown(None, node, value) if verdict is None else Constant(span, not verdict)
        number = value.value if isinstance(value, Constant) else None
        if isinstance(number, int | float) and isinstance(node.op, ast.USub | ast.UAdd):
            return Constant(span, -number if isinstance(node.op, ast.USub) else number)
        return self.or_unknown(None, node, value)

    def on_BoolOp(self, node: ast.BoolOp, scope: Namespace) -> Value:
        stops = isinstance(node.op, ast.Or)
        options: list[Value] = []
        asked: list[Value] = []
        value: Value = Constant(self.span(node), None)
        for each in node.values:
            value = self.evaluate(each, scope)
            asked.append(value)
            verdict = truth(value)
            if verdict is None:
                options.append(value)
            elif verdict is stops:
                break
        self.on_operands(node, *asked)
        if not options or options == [value]:
            return value
        return self.unknown_expression(node, options=tuple(options if value in options else [*options, value]))

    def on_Compare(self, node: ast.Compare, scope: Namespace) -> Value:
        left, is_known = self.evaluate(node.left, scope), True
        for kind, each in zip(node.ops, node.comparators, strict=True):
            right = self.evaluate(each, scope)
            self.on_operands(node, left, right)
            verdict = compare(type(kind), left, right)
            if verdict is False:
                return Constant(self.span(node), False)
            is_known, left = is_known and verdict is True, right
        return Constant(self.span(node), True) if is_known else self.unknown_expression(node)

    def on_IfExp(self, node: ast.IfExp, scope: Namespace) -> Value:
        verdict = truth(self.evaluate(node.test, scope))
        if verdict is not None:
            return self.evaluate(node.body if verdict else node.orelse, scope)
        with self.assuming(f"{self.quoted(self.span(node.test))} can't be evaluated"):
            options = (self.evaluate(node.body, scope), self.evaluate(node.orelse, scope))
        return self.unknown_expression(node, options=options)

    def on_NamedExpr(self, node: ast.NamedExpr, scope: Namespace) -> Value:
        value = self.evaluate(node.value, scope)
        scope.bind(node.target.id, value)
        return value

    def on_JoinedStr(self, node: ast.JoinedStr, scope: Namespace) -> Value:
        span, before = self.span(node), self.fixed
        self.fixed = span
        try:
            return join_texts([self.format_piece(each, scope, span) for each in node.values], span)
        finally:
            self.fixed = before

    def format_piece(self, node: ast.expr, scope: Namespace, span: Span) -> Value:
        if not isinstance(node, ast.FormattedValue):
            return self.evaluate(node, scope)
        value = self.evaluate(node.value, scope)
        self.on_operands(node, value)
        spec = self.evaluate(node.format_spec, scope) if node.format_spec else Text(span, "")
        conversion = chr(node.conversion) if node.conversion > 0 else ""
        if not isinstance(spec, Text):
            return self.unknown_expression(node)
        return format_value(value, spec.text, conversion, span)
