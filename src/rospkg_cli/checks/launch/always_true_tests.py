"""Tests of if and while in a launch file that are a substitution or condition itself, which is always true (LCH014)."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping

from ...languages.python.evaluate.values import Call
from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of, nodes_of_kind
from ...package.launch.evaluated_launch import EvaluatedLaunch
from ...package.launch.launch_classes import is_resolved_at_run_time, type_name
from ...source import Span
from ..fault import Fault
from .python_truth import AT_RUN_TIME
from .repeated_tests import RepeatedTests

REPEATED = "what is added under it has a `condition` that says the same, so remove the test"


def test_faults(launch: EvaluatedLaunch) -> Iterator[Fault]:
    """Yield the tests of `if` and `while` that are a substitution or a condition itself, which is always true."""
    file = launch.file
    made = {call.span: call for call in launch.calls if is_resolved_at_run_time(call)}
    if not made:
        return
    bound, repeated = bindings_of(file, made), RepeatedTests(launch)
    for node in nodes_of(file.tree):
        tests = list(operands(node.test)) if isinstance(node, ast.If | ast.IfExp | ast.While) else []
        calls = [bound.get(test.id) if isinstance(test, ast.Name) else made.get(file.span(test)) for test in tests]
        found = [(file.span(test), call) for test, call in zip(tests, calls, strict=True) if call is not None]
        for span, call in found[:1]:
            message = f"{type_name(call)} itself is always true for Python: {AT_RUN_TIME}"
            if repeated.is_repeated(node, [each for _, each in found]):
                yield Fault(span, f"{message}; {REPEATED}", "info")
            else:
                yield Fault(span, f"{message}; test it in an OpaqueFunction, or pass a `condition`", "warning")


def bindings_of(file: PythonFile, made: Mapping[Span, Call]) -> Mapping[str, Call | None]:
    """Return what each name of a file holds wherever it is bound; None where it may hold something else."""
    found: dict[str, Call | None] = {}
    values = {id(node.targets[0]): node.value for node in nodes_of_kind(file.tree, ast.Assign)}
    for node in nodes_of(file.tree):
        if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
            value = values.get(id(node))
            call = made.get(file.span(value)) if value is not None else None
            found[node.id] = call if found.get(node.id, call) is not None else None
        elif isinstance(node, ast.arg):
            found[node.arg] = None
    return found


def operands(test: ast.expr) -> Iterator[ast.expr]:
    """Yield a test, and the operands of its `and` and `or`."""
    yield test
    for each in test.values if isinstance(test, ast.BoolOp) else ():
        yield from operands(each)
