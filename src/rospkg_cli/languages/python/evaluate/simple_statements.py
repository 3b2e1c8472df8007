"""Execute statements that contain no others."""

from __future__ import annotations

import ast
import sys

from .calls import Calls
from .limits import Flow
from .list_methods import extend_by, take_item
from .operators import binary_operation
from .values import Call, Constant, Namespace, Sequence, Symbol

ALWAYS_THERE = sys.stdlib_module_names | {"setuptools"}
"""Modules that are importable wherever a setup.py runs."""

EXITS = frozenset({"sys.exit", "exit", "quit", "os._exit"})


class SimpleStatements(Calls):
    """Executes assignments, imports, `return` and other simple statements."""

    def do_Expr(self, node: ast.Expr, scope: Namespace) -> Flow | None:
        if isinstance(node.value, ast.Call):
            function = self.evaluate(node.value.func, scope) if isinstance(node.value.func, ast.Name) else None
            name = function.name if isinstance(function, Symbol) else ast.unparse(node.value.func)[:20]
            if name in EXITS:
                return Flow.RAISE
        self.evaluate(node.value, scope)
        return None

    def do_Assign(self, node: ast.Assign, scope: Namespace) -> None:
        value = self.evaluate(node.value, scope)
        for target in node.targets:
            self.assign(target, value, scope)

    def do_AnnAssign(self, node: ast.AnnAssign, scope: Namespace) -> None:
        if node.value is not None:
            self.assign(node.target, self.evaluate(node.value, scope), scope)

    def do_AugAssign(self, node: ast.AugAssign, scope: Namespace) -> None:
        target = node.target
        old = self.evaluate(ast.copy_location(as_load(target), target), scope)
        value = self.evaluate(node.value, scope)
        if isinstance(old, Sequence) and old.kind != "tuple" and isinstance(node.op, ast.Add | ast.BitOr):
            extend_by(self, old, value, Call(self.span(node), "+="))
            return
        found = binary_operation(type(node.op), old, value, self.span(node))
        self.assign(target, self.or_unknown(found, node.value, old, value), scope)

    def do_Delete(self, node: ast.Delete, scope: Namespace) -> None:
        for target in node.targets:
            if isinstance(target, ast.Name):
                scope.names.pop(target.id, None)
            elif isinstance(target, ast.Subscript):
                holder = self.evaluate(target.value, scope)
                if isinstance(holder, Sequence):
                    take_item(self, holder, self.index(target.slice, scope), self.span(node))
                else:
                    self.mark_unknown(holder, self.span(node), f"{self.quoted(self.span(node))} can't be followed")

    def do_Return(self, node: ast.Return, scope: Namespace) -> Flow:
        value = self.evaluate(node.value, scope) if node.value else Constant(self.span(node), None)
        scope.returns.append(value)
        return Flow.RETURN

    def do_Raise(self, node: ast.Raise, scope: Namespace) -> Flow:
        return Flow.RAISE

    def do_Break(self, node: ast.Break, scope: Namespace) -> Flow:
        return Flow.BREAK

    def do_Continue(self, node: ast.Continue, scope: Namespace) -> Flow:
        return Flow.CONTINUE

    def do_Pass(self, node: ast.Pass, scope: Namespace) -> None:
        """Nothing happens."""

    def do_Assert(self, node: ast.Assert, scope: Namespace) -> None:
        """It holds, or nothing after it matters."""

    def do_Global(self, node: ast.Global | ast.Nonlocal, scope: Namespace) -> None:
        for name in node.names:
            at: Namespace | None = scope.parent if isinstance(node, ast.Nonlocal) else scope.top
            while isinstance(node, ast.Nonlocal) and at is not None and name not in at.names:
                at = at.parent
            scope.outer[name] = at or scope.top

    do_Nonlocal = do_Global

    def do_Import(self, node: ast.Import, scope: Namespace) -> None:
        for alias in node.names:
            self.bind_uncertain_import(alias.name)
            bound = alias.name if alias.asname else alias.name.partition(".")[0]
            scope.bind(alias.asname or bound, Symbol(self.span(alias), bound))

    def do_ImportFrom(self, node: ast.ImportFrom, scope: Namespace) -> None:
        module = "." * node.level + (node.module or "")
        self.bind_uncertain_import(module)
        for alias in node.names:
            if alias.name == "*":
                scope.bind("*", Symbol(self.span(alias), module))
            else:
                between = "" if module.endswith(".") else "."
                scope.bind(alias.asname or alias.name, Symbol(self.span(alias), f"{module}{between}{alias.name}"))

    def bind_uncertain_import(self, module: str) -> None:
        if module.partition(".")[0] not in ALWAYS_THERE:
            self.unknown_count += 1


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
