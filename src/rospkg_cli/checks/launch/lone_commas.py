"""Actions that a comma behind them makes a tuple of: `node = Node(…),`."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping

from ...languages.python.evaluate.values import Argument, Call, Sequence, Value
from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...light_dataclasses import replace
from ...package.launch.launch_classes import class_of
from ...source import Span
from ..fault import Fault
from .list_arguments import action_list_faults

ADDS = frozenset({"add_action", "add_entity"})
Commas = Mapping[Span, tuple[str, Span]]
"""For each tuple of one item without brackets: the name that it is bound to, and its comma."""


def lone_commas(file: PythonFile) -> Commas:
    found: dict[Span, tuple[str, Span]] = {}
    for node in (*nodes_of_kind(file.tree, ast.Assign), *nodes_of_kind(file.tree, ast.AnnAssign)):
        match node:
            case (
                ast.Assign(targets=[ast.Name(id=name)], value=ast.Tuple(elts=[item]) as value)
                | ast.AnnAssign(target=ast.Name(id=name), value=ast.Tuple(elts=[item]) as value)
            ):
                span, end = file.span(value), file.span(item).end
                comma = file.source.text.find(",", end, span.end)
                if comma >= 0 and file.source.text[span.start] != "(":
                    found[span] = name, Span(comma, comma + 1)
    return found


def at_the_comma(fault: Fault, argument: Argument, commas: Commas) -> Fault:
    """Return a fault of a value, or of an item of it, at the comma that makes a tuple of it, if one does."""
    value = argument.value
    items: list[tuple[Value, Span]] = [(value, argument.span)]
    if isinstance(value, Sequence):
        items += zip(value.items, value.places, strict=True)
    for item, place in items:
        is_here = place.contains(fault.span)
        if isinstance(item, Sequence) and item.span in commas and is_here:
            name, comma = commas[item.span]
            said = fault.message.removesuffix("; put a `*` before it")
            message = f"the comma makes a tuple of `{name}`: {said}; remove the comma"
            return replace(fault, span=comma, message=message, repair=None)
    return fault


def used_at_the_comma(fault: Fault, operands: tuple[Value, ...], commas: Commas) -> Fault:
    """Return a fault of what Python does with values, at the comma that makes a tuple of one, if one does."""
    for each in operands:
        if isinstance(each, Sequence) and each.span in commas:
            name, comma = commas[each.span]
            message = f"the comma makes a tuple of `{name}`: {fault.message}; remove the comma"
            return replace(fault, span=comma, message=message, repair=None)
    return fault


def added_faults(call: Call) -> Iterator[tuple[Fault, Argument]]:
    """Yield what is added to a launch description and is no action."""
    made = call.receiver
    if call.callee in ADDS and isinstance(made, Call) and class_of(made) == "LaunchDescription":
        for argument in call.arguments[:1]:
            one = Sequence(argument.span, "list", [argument.value], [argument.span])
            for fault in action_list_faults(one, f"`{call.callee}`"):
                message = fault.message.replace("takes a list of actions", "takes one")
                yield replace(fault, message=message.removesuffix("; put a `*` before it")), argument
