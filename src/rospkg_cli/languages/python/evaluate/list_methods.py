"""Methods of lists and sets, which change them in place, certainly or possibly."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterable, Mapping

from ....light_dataclasses import replace
from ....source import Span
from .conversion import NoPythonValueError, to_python
from .iterables import is_many, items_of
from .limits import ITEM, MAX_ITEMS, STEP, spend
from .state import EvaluationState
from .truthiness import compare, truth
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
        doubt_items(state, value, call.span)
        return None
    if not -len(value.items) <= at < len(value.items):
        return None
    value.places.pop(at)
    return value.items.pop(at)


def place_of(state: EvaluationState, value: Sequence, at: Value | None) -> int | None:
    """Return the index of the item that a certain change is about; None where that is unknown."""
    index = at.value if isinstance(at, Constant) else None
    if not isinstance(index, int) or not value.is_complete or len(state.conditions) > value.open_conditions:
        return None
    return index if -len(value.items) <= index < len(value.items) else None


def put_item(state: EvaluationState, value: Sequence, at: Value | None, item: Value, span: Span) -> None:
    """`items[at] = item`, certainly or possibly."""
    index = place_of(state, value, at)
    if index is not None:
        value.items[index], value.places[index] = item, span
        return
    doubt_items(state, value, span)
    state.mark_unknown(value, span, f"{state.quoted(span)} can't be followed")


def take_item(state: EvaluationState, value: Sequence, at: Value | None, span: Span) -> None:
    """`del items[at]`, certainly or possibly."""
    index = place_of(state, value, at)
    if index is None:
        doubt_items(state, value, span)
        return
    del value.items[index], value.places[index]


def doubt_items(state: EvaluationState, value: Sequence, span: Span) -> None:
    """Mark each item of a list as one that may be there, or not any more."""
    why = f"{state.quoted(span)} can't be followed"
    spend(len(value.items) * STEP)
    value.items[:] = [
        item if is_many(item) else state.unknown(item.span, why, many=True, options=(item,)) for item in value.items
    ]


def clear(state: EvaluationState, value: Sequence, call: Call) -> Value | None:
    if len(state.conditions) > value.open_conditions:
        doubt_items(state, value, call.span)
        return Constant(call.span, None)
    value.items.clear()
    value.places.clear()
    return Constant(call.span, None)


def copy_list(state: EvaluationState, value: Sequence, call: Call) -> Value | None:
    spend(len(value.items) * ITEM)
    return replace(value, items=list(value.items), places=list(value.places), open_conditions=len(state.conditions))


def sort(state: EvaluationState, value: Sequence, call: Call) -> Value | None:
    """list.sort; where the order is not known, it hardly ever matters in a setup.py or a launch file."""
    spend(len(value.items) * STEP)
    key, backwards = call.get("key"), call.get("reverse")
    try:
        keys = [to_python(state.apply(key, [item], call.span) if key else item) for item in value.items]
        order = sorted(range(len(keys)), key=keys.__getitem__, reverse=bool(backwards and truth(backwards)))  # type: ignore[arg-type]
    except (NoPythonValueError, TypeError):
        return Constant(call.span, None)
    return rearrange(value, order, call)


def reverse(state: EvaluationState, value: Sequence, call: Call) -> Value | None:
    spend(len(value.items))
    return rearrange(value, range(len(value.items))[::-1], call)


def rearrange(value: Sequence, order: Iterable[int], call: Call) -> Value:
    places = list(order)
    value.items[:], value.places[:] = [value.items[at] for at in places], [value.places[at] for at in places]
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
    "sort": sort,
    "reverse": reverse,
    "count": count,
    "add": add,
}
