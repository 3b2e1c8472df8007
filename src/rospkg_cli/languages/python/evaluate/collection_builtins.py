"""Builtins that make lists and dicts of iterables; an unknown item keeps its position."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .conversion import NoPythonValueError, to_python
from .dict_methods import merge
from .iterables import is_many, items_of
from .limits import MAX_ITEMS, LimitError
from .state import EvaluationState, Intrinsic
from .truthiness import truth
from .values import Call, Constant, Sequence, Text, Value
from .values import Mapping as MappingValue


def as_list(state: EvaluationState, call: Call) -> Value | None:
    if not call.positional:
        return state.computed_list(call.span, [])
    items = items_of(state, call.positional[0])
    return None if items is None else state.computed_list(call.span, items)


def as_tuple(state: EvaluationState, call: Call) -> Value | None:
    found = as_list(state, call)
    if isinstance(found, Sequence):
        found.kind = "tuple"
    return found


def as_set(state: EvaluationState, call: Call) -> Value | None:
    found = as_list(state, call)
    if not isinstance(found, Sequence):
        return None
    distinct: dict[Any, Value] = {}
    try:
        for item in found.items:
            distinct.setdefault(id(item) if is_many(item) else to_python(item), item)
    except (NoPythonValueError, TypeError):
        return None
    return Sequence(
        call.span, "set", list(distinct.values()), [call.span] * len(distinct), open_conditions=found.open_conditions
    )


def as_dict(state: EvaluationState, call: Call) -> Value | None:
    result = MappingValue(call.span, open_conditions=len(state.conditions))
    source = call.positional[0] if call.positional else None
    if isinstance(source, MappingValue):
        merge(result, source)
    elif source is not None:
        for pair in items_of(state, source) or [source]:
            if not isinstance(pair, Sequence) or len(pair.items) != 2:
                return None
            try:
                result.items[to_python(pair.items[0])] = (pair.items[0], pair.items[1])
            except (NoPythonValueError, TypeError):
                return None
    for argument in call.arguments:
        if argument.name:
            result.items[argument.name] = (Text(argument.span, argument.name), argument.value)
    return result


def as_range(state: EvaluationState, call: Call) -> Value | None:
    try:
        bounds = [value for value in map(to_python, call.positional) if isinstance(value, int)]
        numbers = range(*bounds)
        count = len(numbers)
    except (NoPythonValueError, TypeError, ValueError, OverflowError):
        return None
    if len(bounds) != len(call.positional):
        return None
    if count > MAX_ITEMS:
        raise LimitError(f"a range of more than {MAX_ITEMS} numbers")
    return state.computed_list(call.span, [Constant(call.span, number) for number in numbers])


def as_sorted(state: EvaluationState, call: Call) -> Value | None:
    items = items_of(state, call.positional[0]) if call.positional else None
    if items is None:
        return None
    key = call.get("key")
    try:
        keyed = [(item, to_python(state.apply(key, [item], call.span) if key else item)) for item in items]
        reverse = call.get("reverse")
        keyed.sort(key=lambda pair: pair[1], reverse=bool(reverse and truth(reverse)))  # type: ignore[arg-type,return-value]
        items = [item for item, _ in keyed]
    except (NoPythonValueError, TypeError):
        return state.computed_list(call.span, items) if any(map(is_many, items)) else None
    return state.computed_list(call.span, items)


def as_reversed(state: EvaluationState, call: Call) -> Value | None:
    items = items_of(state, call.positional[0]) if call.positional else None
    return None if items is None else state.computed_list(call.span, items[::-1])


def as_enumerate(state: EvaluationState, call: Call) -> Value | None:
    items = items_of(state, call.positional[0]) if call.positional else None
    start = call.get("start", 1) or Constant(call.span, 0)
    if items is None or any(map(is_many, items)) or not isinstance(start, Constant) or not isinstance(start.value, int):
        return None
    pairs: list[Value] = []
    for number, item in enumerate(items, start.value):
        pairs.append(Sequence(call.span, "tuple", [Constant(call.span, number), item], [call.span] * 2))
    return state.computed_list(call.span, pairs)


COLLECTION_BUILTINS: Mapping[str, Intrinsic] = {
    "list": as_list,
    "tuple": as_tuple,
    "set": as_set,
    "frozenset": as_set,
    "dict": as_dict,
    "collections.OrderedDict": as_dict,
    "iter": as_list,
    "range": as_range,
    "sorted": as_sorted,
    "reversed": as_reversed,
    "enumerate": as_enumerate,
}
