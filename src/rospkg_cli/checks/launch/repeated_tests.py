"""Tests that Python always passes, where what is added under them has a condition of its own that says the same."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator

from ...languages.python.evaluate.values import Call, Text, Value
from ...languages.python.nodes import nodes_of, nodes_of_kind
from ...light_dataclasses import dataclass
from ...package.launch.evaluated_launch import EvaluatedLaunch
from ...package.launch.launch_classes import class_of, is_condition
from ...ros.launch_calls import ACTIONS

ADDS = frozenset({"add_action", "append"})
COMPARING = frozenset({"LaunchConfigurationEquals", "LaunchConfigurationNotEquals"})
NEGATIVE = frozenset({"UnlessCondition", "LaunchConfigurationNotEquals"})
TRUTHS = {"true": "true", "1": "true", "false": "false", "0": "false"}
NOT = {"true": "false", "false": "true"}


@dataclass(frozen=True)
class RepeatedTests:
    launch: EvaluatedLaunch

    def is_repeated(self, node: ast.AST, tested: Iterable[Call]) -> bool:
        """Return whether all that stands under an `if` adds actions whose own conditions ask for what is tested."""
        wanted = [asked_by(each) for each in tested]
        if not isinstance(node, ast.If) or node.orelse or None in wanted:
            return False
        added = [self.added_by(statement) for statement in node.body]
        return all(each and all(self.asks(call, wanted) for call in each) for each in added)

    def asks(self, action: Call, wanted: Iterable[tuple[str, str] | None]) -> bool:
        condition = action.get("condition")
        asked = asked_by(condition) if condition is not None and class_of(action) in ACTIONS else None
        return asked is not None and all(each == asked for each in wanted)

    def added_by(self, statement: ast.stmt) -> list[Call]:
        """Return the actions of which a statement adds one; nothing where it does something else, or may."""
        call = statement.value if isinstance(statement, ast.Expr) else None
        if not isinstance(call, ast.Call) or not isinstance(call.func, ast.Attribute) or call.func.attr not in ADDS:
            return []
        if len(call.args) != 1 or call.keywords:
            return []
        values = list(self.values_of(call.args[0]))
        found = [each for value in values for each in self.made_at(value)]
        return found if all(self.made_at(value) for value in values) else []

    def values_of(self, written: ast.expr) -> Iterator[ast.expr | None]:
        """Yield what an expression may be, None for what is not known; a `None` alone adds nothing."""
        if not isinstance(written, ast.Name):
            yield written
            return
        bound = {
            id(e.targets[0]): e.value for e in nodes_of_kind(self.launch.file.tree, ast.Assign) if len(e.targets) == 1
        }
        for node in nodes_of(self.launch.file.tree):
            if isinstance(node, ast.Name) and node.id == written.id and not isinstance(node.ctx, ast.Load):
                value = bound.get(id(node))
                if not (isinstance(value, ast.Constant) and value.value is None):
                    yield value
            elif isinstance(node, ast.arg) and node.arg == written.id:
                yield None

    def made_at(self, value: ast.expr | None) -> list[Call]:
        span = self.launch.file.span(value) if value is not None else None
        return [call for call in self.launch.calls if call.span == span]


def asked_by(value: Value) -> tuple[str, str] | None:
    """Return the argument that a condition or a substitution asks for, and the value that it wants; None for others."""
    if not isinstance(value, Call):
        return None
    kind = class_of(value)
    if kind == "LaunchConfiguration":
        name = value.get("variable_name", 0)
        return (name.text, "true") if isinstance(name, Text) else None
    if kind in COMPARING:
        name, text = value.get("launch_configuration_name", 0), value.get("expected_value", 1)
        if not isinstance(name, Text) or not isinstance(text, Text):
            return None
        return outcome(name.text, TRUTHS.get(text.text.lower(), text.text), is_negated=kind in NEGATIVE)
    inner = value.get("predicate_expression", 0) if is_condition(value) else None
    asked = asked_by(inner) if inner is not None else None
    return outcome(*asked, is_negated=kind in NEGATIVE) if asked is not None else None


def outcome(name: str, wanted: str, *, is_negated: bool) -> tuple[str, str]:
    return name, (NOT.get(wanted, f"not {wanted}") if is_negated else wanted)
