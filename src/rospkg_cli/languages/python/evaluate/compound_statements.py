"""Execute statements that contain others, with certain and possible effects."""

from __future__ import annotations

import ast
from collections.abc import Callable
from typing import Any

from ..constant_truth import constant_truth
from ..nodes import nodes_of
from .conversion import is_equal
from .endless_loops import rounds_of
from .iterables import items_of
from .limits import ITEM, Flow, spend
from .simple_statements import SimpleStatements
from .truthiness import truth
from .values import Class, Function, Namespace, Sequence, Symbol, Unknown, Value


class CompoundStatements(SimpleStatements):
    """Executes conditions, loops, `try`, `with` and `match`."""

    def execute(self, body: list[ast.stmt], scope: Namespace) -> Flow:
        """Run statements one after the other; raises LimitError."""
        for index, node in enumerate(body):
            self.tick()
            handler: Callable[[Any, Namespace], Flow | None] | None = getattr(self, f"do_{type(node).__name__}", None)
            flow = (handler(node, scope) if handler else self.do_unknown(node, scope)) or Flow.NEXT
            if flow is Flow.MAYBE:
                self.branch([body[index + 1 :]], scope, f"{self.quoted(self.span(node))} may leave early")
            if flow is not Flow.NEXT:
                return flow
        return Flow.NEXT

    def do_unknown(self, node: ast.stmt, scope: Namespace) -> Flow | None:
        """A statement without a method here: the names that it binds are unknown from here on."""
        why = f"{self.quoted(self.span(node))} can't be evaluated"
        for each in nodes_of(node):
            spend(ITEM)
            if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store):
                scope.bind(each.id, self.unknown(self.span(each), why))
        return None

    def branch(self, bodies: list[list[ast.stmt]], scope: Namespace, why: str) -> Flow:
        """Run alternatives of which one may happen (perhaps none), and merge the names that they bind."""
        before, ends, flows = dict(scope.names), [], []
        spend(len(before) * (len(bodies) + 1))
        for body in bodies:
            scope.names = dict(before)
            with self.assuming(why):
                flows.append(self.execute(body, scope))
            if flows[-1] in (Flow.NEXT, Flow.MAYBE):
                ends.append(scope.names)
        if len(bodies) == 1:
            ends.append(before)
            flows.append(Flow.NEXT)
        scope.names = self.join_scopes(ends or [before], why)
        leaves = {flow for flow in flows if flow is not Flow.RAISE}
        if not leaves:
            return Flow.RAISE
        return leaves.pop() if len(leaves) == 1 else Flow.MAYBE

    def join_scopes(self, ends: list[dict[str, Value]], why: str) -> dict[str, Value]:
        result = dict(ends[0])
        for end in ends[1:]:
            spend(len(result) * ITEM)
            for name in [*result, *[name for name in end if name not in result]]:
                result[name] = self.one_of(result.get(name), end.get(name), why)
        return result

    def one_of(self, a: Value | None, b: Value | None, why: str) -> Value:
        """Return the merge of the values of two branches; an imported name wins."""
        if a is None or b is None:
            found = b if a is None else a
            assert found is not None
            return (
                found
                if isinstance(found, Symbol | Function | Class)
                else self.unknown(found.span, why, options=(found,))
            )
        if is_equal(a, b) or isinstance(a, Symbol):
            return a
        if isinstance(b, Symbol):
            return b
        return self.unknown(a.span, why, options=(a, b))

    def do_If(self, node: ast.If, scope: Namespace) -> Flow:
        verdict = truth(self.evaluate(node.test, scope))
        if verdict is None:
            verdict = constant_truth(node.test, {})
        if verdict is not None:
            return self.execute(node.body if verdict else node.orelse, scope)
        why = f"{self.quoted(self.span(node.test))} can't be evaluated"
        return self.branch([node.body, node.orelse], scope, why)

    def do_For(self, node: ast.For | ast.AsyncFor, scope: Namespace) -> Flow | None:
        source = self.evaluate(node.iter, scope)
        items, span = items_of(self, source), self.span(node.iter)
        if items is None:
            items = [self.unknown(span, getattr(source, "why", f"{self.quoted(span)} can't be evaluated"), many=True)]
        for index, item in enumerate(items):
            perhaps = isinstance(item, Unknown) and item.is_many
            if isinstance(item, Unknown) and item.is_many:
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
            if isinstance(source, Sequence):
                items += source.items[len(items) :]  # Python goes on with what the body appends
        return self.execute(node.orelse, scope)

    def rest_of_loop(self, node: ast.For | ast.AsyncFor, items: list[Value], scope: Namespace) -> Flow:
        """Run the rounds after one that perhaps was the last."""
        why = f"{self.quoted(self.span(node.iter))} may end early"
        for item in items:
            before = dict(scope.names)
            spend(len(before))
            self.assign(node.target, item, scope)
            self.branch([node.body], scope, why)
            scope.names = self.join_scopes([scope.names, before], why)
        self.branch([node.orelse], scope, why)
        return Flow.MAYBE if any(isinstance(each, ast.Return) for each in nodes_of(node)) else Flow.NEXT

    do_AsyncFor = do_For

    def do_While(self, node: ast.While, scope: Namespace) -> Flow | None:
        for _ in rounds_of(scope):
            verdict = truth(self.evaluate(node.test, scope))
            if verdict is None:
                self.branch([node.body], scope, f"{self.quoted(self.span(node.test))} can't be evaluated")
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
        return None

    def do_Try(self, node: ast.Try, scope: Namespace) -> Flow:
        before, doubts = dict(scope.names), self.unknown_count
        flow = self.execute(node.body, scope)
        raises = flow is Flow.RAISE or self.unknown_count > doubts
        if flow is Flow.NEXT:
            flow = self.execute(node.orelse, scope)
        if raises and node.handlers:
            ends = [scope.names] if flow in (Flow.NEXT, Flow.MAYBE) else []
            for handler in node.handlers:
                spend(len(before))
                scope.names = dict(before)
                if handler.name:
                    scope.bind(handler.name, self.unknown(self.span(handler), "it depends on what is raised"))
                with self.assuming("it is unknown whether an exception is raised"):
                    if self.execute(handler.body, scope) in (Flow.NEXT, Flow.MAYBE):
                        ends.append(scope.names)
            is_left = flow not in (Flow.NEXT, Flow.MAYBE, Flow.RAISE)
            flow = Flow.NEXT if flow is Flow.RAISE else Flow.MAYBE if is_left and ends else flow
            scope.names = self.join_scopes(ends or [before], "it is unknown whether an exception is raised")
        final = self.execute(node.finalbody, scope)
        return flow if final is Flow.NEXT else final

    do_TryStar = do_Try

    def do_With(self, node: ast.With | ast.AsyncWith, scope: Namespace) -> Flow:
        for item in node.items:
            value = self.evaluate(item.context_expr, scope)
            if item.optional_vars is not None:
                self.assign(item.optional_vars, value, scope)
        return self.execute(node.body, scope)

    do_AsyncWith = do_With

    def do_Match(self, node: ast.Match, scope: Namespace) -> Flow:
        self.evaluate(node.subject, scope)
        why = f"{self.quoted(self.span(node.subject))} is not matched here"
        return self.branch([*[case.body for case in node.cases], []], scope, why)


def has_break(node: ast.For | ast.AsyncFor) -> bool:
    return any(isinstance(each, ast.Break | ast.Return) for each in nodes_of(node))
