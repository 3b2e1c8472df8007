"""Launch arguments that Python tests as texts, where every text that is not empty is true: `'False'` (LCH014)."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.evaluate.values import Call, Text
from ...languages.python.nodes import nodes_of
from ...package.launch.evaluated_launch import EvaluatedLaunch
from ...package.launch.launch_classes import class_of
from ..fault import Fault
from .always_true_tests import bindings_of, operands

TRUTHS = frozenset({"true", "false"})


def performed_faults(launch: EvaluatedLaunch) -> Iterator[Fault]:
    """Yield the tests of a text that `perform` returned, where the argument's default is a truth value."""
    truths = {declared for call in launch.calls if (declared := name_of_truth(call))}
    made = {call.span: call for call in launch.calls if performed_name(call) in truths}
    bound = bindings_of(launch.file, made) if made else {}
    for node in nodes_of(launch.file.tree) if made else ():
        for test in operands(node.test) if isinstance(node, ast.If | ast.IfExp | ast.While) else ():
            is_negated = isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not)
            name = test.operand if isinstance(test, ast.UnaryOp) and is_negated else test
            if isinstance(name, ast.Name) and bound.get(name.id) is not None:
                result = "false here, as any text is true" if is_negated else "true for Python, as any text is"
                message = f"`{name.id}` is a text, and `'False'` is {result}: compare it, `{name.id} == 'True'`"
                yield Fault(launch.file.span(test), message, "warning")


def name_of_truth(call: Call) -> str | None:
    """Return the name of an argument that a call declares with `true` or `false` as its default."""
    default, name = call.get("default_value"), call.get("name", 0)
    if class_of(call) != "DeclareLaunchArgument" or not isinstance(name, Text) or not isinstance(default, Text):
        return None
    return name.text if default.text.lower() in TRUTHS else None


def performed_name(call: Call) -> str | None:
    """Return the name of the launch configuration whose text a call returns."""
    receiver = call.receiver
    if call.callee != "perform" or not isinstance(receiver, Call) or class_of(receiver) != "LaunchConfiguration":
        return None
    name = receiver.get("variable_name", 0)
    return name.text if isinstance(name, Text) else None
