"""Methods of lists and sets, which change them in place, certainly or possibly."""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping

from ....light_dataclasses import replace
from .conversion import NoPythonValueError, to_python
from .iterables import items_of
from .limits import ITEM, MAX_ITEMS, spend
from .state import EvaluationState
from .truthiness import compare
from .values import Call, Constant, Sequence, Value


def mark_unknown(state: EvaluationState, value: Value, call: Call) -> Value | None:
    """Mark a list or dict whose change can't be followed as partly unknown."""
    state.mark_unknown(value, call.span, f"{state.quoted(call.span)} can't be followed")
    return None


def append(state: EvaluationState, value: Sequence, call: Call) -> Value | None:
    for argument in call.arguments[:1]:
        state.add_item(value, argument.value, argument.span)
    return Constant(call.span, None)


def extend(state: EvaluationState, value: Sequence, call: Call) -> Value | None:
    source = call.positional[0] if call.positional else None
    extend_by(state, value, source, call)
    return Constant(call.span, None)


def extend_by(state: EvaluationState, value: Sequence, source: Value | None, call: Call) -> None:
    items = items_of(state, source) if source is not None else None
    if items is None:
        state.mark_unknown(value, call.span, getattr(source, "why", f"{state.quoted(call.span)} can't be evaluated"))
        return
    places = source.places if isinstance(source, Sequence) else [call.span] * len(items)
    for item, place in zip(items, list(places), strict=False):
        state.add_item(value, item, place)


def insert(state: EvaluationState, value: Sequence, call: Call) -> Value | None:
    at = call.positional[0] if len(call.positional) == 2 else None
    if not isinstance(at, Constant) or not isinstance(at.value, int) or abs(at.value) > MAX_ITEMS:
        return mark_unknown(state, value, call)
    spend(len(value.items))
    state.add_item(value, call.positional[1], call.arguments[1].span)
    item, place = value.items.pop(), value.places.pop()
    value.items.insert(at.value, item)
    value.places.insert(at.value, place)
    return Constant(call.span, None)


def remove(state: EvaluationState, value: Sequence, call: Call) -> Value | None:
    """list.remove and set.discard: for certain only where the item is there."""
    wanted = call.positional[0] if call.positional else None
    for index, item in enumerate(value.items):
        spend(2 * ITEM)
        verdict = compare(ast.Eq, item, wanted) if wanted is not None else None
        if verdict and len(state.conditions) <= value.open_conditions:
            del value.items[index], value.places[index]
            return Constant(call.span, None)
        if verdict is not False:
            return mark_unknown(state, value, call)
    return Constant(call.span, None)


def pop(state: EvaluationState, value: Sequence, call: Call) -> Value | None:
    at = call.positional[0].value if call.positional and isinstance(call.positional[0], Constant) else -1
    if not value.is_complete or not isinstance(at, int) or len(state.conditions) > value.open_conditions:
        return mark_unknown(state, value, call)
    if not -len(value.items) <= at < len(value.items):
        return None
    value.places.pop(at)
    return value.items.pop(at)


def clear(state: EvaluationState, value: Sequence, call: Call) -> Value | None:
    if len(state.conditions) > value.open_conditions:
        return mark_unknown(state, value, call)
    value.items.clear()
    value.places.clear()
    return Constant(call.span, None)


def copy_list(state: EvaluationState, value: Sequence, call: Call) -> Value | None:
    spend(len(value.items) * ITEM)
    return replace(value, items=list(value.items), places=list(value.places), open_conditions=len(state.conditions))


def reorder(state: EvaluationState, value: Sequence, call: Call) -> Value | None:
    """sort and reverse: the order hardly ever matters in a setup.py or a launch file."""
    spend(len(value.items))
    if call.callee == "reverse":
        value.items.reverse()
        value.places.reverse()
    return Constant(call.span, None)


def count(state: EvaluationState, value: Sequence, call: Call) -> Value | None:
    try:
        items = to_python(value)
        return Constant(call.span, items.count(to_python(call.positional[0])))  # type: ignore[attr-defined]
    except (NoPythonValueError, IndexError, AttributeError):
        return None


def add(state: EvaluationState, value: Sequence, call: Call) -> Value | None:
    """set.add."""
    wanted = call.positional[0] if call.positional else None
    spend(len(value.items) * 2 * ITEM)
    if wanted is not None and not any(compare(ast.Eq, item, wanted) for item in value.items):
        state.add_item(value, wanted, call.arguments[0].span)
    return Constant(call.span, None)


LIST_METHODS: Mapping[str, Callable[[EvaluationState, Sequence, Call], Value | None]] = {
    "append": append,
    "extend": extend,
    "update": extend,
    "insert": insert,
    "remove": remove,
    "discard": remove,
    "pop": pop,
    "clear": clear,
    "copy": copy_list,
    "sort": reorder,
    "reverse": reorder,
    "count": count,
    "add": add,
}
