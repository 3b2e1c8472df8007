"""Actions of a launch file that a plain `ros2 launch` never visits: never added, or under a condition that is off."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from typing import cast

from ...languages.python.evaluate.values import Call
from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_below, nodes_of_kind
from ...lazy_regex import regex
from ...package.launch.argument_defaults import literal_defaults
from ...package.launch.launch_classes import class_of
from ...package.launch.launch_file import LaunchFile
from ...package.launch.python_to_text import text_of
from ...package.launch.text import LaunchText, Substitution
from ...ros.launch_calls import ACTIONS
from ...source import Span
from ..fault import Level
from .python_expressions import filled, parsed

NEVER_ADDED = "but nothing adds the action"
UNUSED = "but nothing uses the value"
NO_ENTRY = "but only where another launch file calls the function"
OFF = "but only if its condition holds (not by default)"
IN_BRANCH = "but only in a branch that is not always taken"
TRUTHS = {"true": True, "1": True, "false": False, "0": False}
"""What IfCondition takes, in lower case. (launch/conditions/evaluate_condition_expression_impl.py)"""

NEGATED = {"IfCondition": False, "UnlessCondition": True, "if": False, "unless": True}
VARIABLE = regex(r"\$\(var ([^()\s]+)\)")


def level_at(file: LaunchFile, span: Span) -> tuple[Level | None, str]:
    """Return the level of a fault in an action, None for the rule's own, and why it is not that."""
    lost = next((each for each in never_added(file.python) if contains(each, span)), None) if file.python else None
    if file.python is not None and lost is not None:
        maker = file.python.source.slice(lost).partition("(")[0].rpartition(".")[2]
        return "info", NEVER_ADDED if maker in ACTIONS else UNUSED
    if file.python is not None and not file.has_entry_point:
        return "warning", NO_ENTRY
    if any(contains(each, span) for each in switched_off(file)):
        return "warning", OFF
    if any(contains(each, span) for each in in_branches(file)):
        return "warning", IN_BRANCH
    return None, ""


def contains(around: Span, span: Span) -> bool:
    return around.start <= span.start and span.end <= around.end


def never_added(file: PythonFile) -> tuple[Span, ...]:
    """Return the calls in functions whose result nothing names: bound to a local that is never read, or to nothing."""
    known = vars(file)
    if "never_added" not in known:  # asked for every action of the file
        known["never_added"] = tuple(dict.fromkeys(unread_values(file)))
    return cast("tuple[Span, ...]", known["never_added"])


def unread_values(file: PythonFile) -> Iterator[Span]:
    loads = [node for node in nodes_of_kind(file.tree, ast.Name) if not is_stored(node)]
    again = {id(node) for node in loads_for_itself(file)}
    loads = [node for node in loads if id(node) not in again]
    if any(node.id == "locals" for node in loads):
        return
    waiting = list(local_values(file))
    while True:  # what only such a value reads is not read either
        read = {node.id for node in loads}
        lost = [value for names, value in waiting if read.isdisjoint(names)]
        if not lost:
            return
        yield from map(file.span, lost)
        inside = {id(node) for value in lost for node in nodes_below(value)} | {id(value) for value in lost}
        loads = [node for node in loads if id(node) not in inside]
        waiting = [(names, value) for names, value in waiting if value not in lost]


def local_values(file: PythonFile) -> Iterator[tuple[list[str], ast.expr]]:
    """Yield what functions bind to plain names, with these."""
    for function in nodes_of_kind(file.tree, ast.FunctionDef):
        for node in nodes_below(function):
            if isinstance(node, ast.Assign):
                names = [target.id for target in node.targets if isinstance(target, ast.Name)]
                if len(names) == len(node.targets):
                    yield names, node.value


def in_branches(file: LaunchFile) -> Iterator[Span]:
    """Yield the actions that Python makes only under an `if` of its own that can't be evaluated."""
    for call in file.evaluated.calls if file.evaluated and file.python else ():
        if not call.is_certain and call.get("condition") is None and class_of(call) in ACTIONS:
            yield call.span


def loads_for_itself(file: PythonFile) -> Iterator[ast.Name]:
    """Yield the reads of a name in what is made of it and bound to it again: `path = Replaced(path)`."""
    for node in nodes_of_kind(file.tree, ast.Assign):
        match node:
            case ast.Assign(targets=[ast.Name(id=name)], value=ast.Call(func=ast.Name(id=made)) as value):
                if made[:1].isupper():
                    yield from (n for n in nodes_below(value) if isinstance(n, ast.Name) and n.id == name)


def is_stored(name: ast.Name) -> bool:
    return isinstance(name.ctx, ast.Store)


def switched_off(file: LaunchFile) -> tuple[Span, ...]:
    """Return the actions whose own condition is false with the defaults of the file's arguments."""
    defaults = literal_defaults(file.arguments, file.assigned)
    return (*in_python(file, defaults), *in_entities(file, defaults))


def in_python(file: LaunchFile, defaults: Mapping[str, str]) -> Iterator[Span]:
    for call in file.evaluated.calls if file.evaluated else ():
        condition = call.get("condition")
        if isinstance(condition, Call) and class_of(condition) in NEGATED:
            value = condition.get("predicate_expression", 0)
            holds = None if value is None else truth(text_of(value), defaults)
            if holds is NEGATED[class_of(condition)]:
                yield call.span


def in_entities(file: LaunchFile, defaults: Mapping[str, str]) -> Iterator[Span]:
    for entity in file.root.walk() if file.root else ():
        for name in ("if", "unless"):
            written = entity.attributes.get(name)
            text = written.text.strip() if written is not None else ""
            found = VARIABLE.fullmatch(text)
            if TRUTHS.get((defaults.get(found.group(1), "") if found else text).lower()) is NEGATED[name]:
                yield entity.span


def truth(text: LaunchText, defaults: Mapping[str, str]) -> bool | None:
    """Return what a condition is with these defaults: of an argument, a literal, or a comparison of both."""
    match text.parts:
        case (Substitution(name="eval", arguments=(expression,)),):
            names = (each.arguments[0].literal for each in expression.substitutions("var") if each.arguments)
            known = all(name in defaults for name in names) and not any(expression.substitutions("?", "env"))
            return compared(filled(expression, None, defaults)) if known else None
        case (Substitution(name="var", arguments=(name,)),):
            return TRUTHS.get(defaults.get(name.literal or "", "").lower())
    return TRUTHS.get((text.literal or "").lower())


def compared(expression: str) -> bool | None:
    """Return the value of `'a' == 'b'`; None for any other expression."""
    match parsed(expression):
        case ast.Expression(ast.Compare(ast.Constant(left), [ast.Eq() | ast.NotEq() as how], [ast.Constant(right)])):
            return bool(left == right) is isinstance(how, ast.Eq)
    return None
