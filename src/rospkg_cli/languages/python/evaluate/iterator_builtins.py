"""Builtins over the items of iterables: zip, map, filter, chain, any, all, len, next, sum."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from .collection_builtins import COLLECTION_BUILTINS
from .iterables import is_many, items_of, plain_function
from .list_methods import take_item
from .state import EvaluationState, Intrinsic
from .truthiness import truth
from .values import Call, Constant, Sequence, Text, Value
from .values import Mapping as MappingValue


def as_zip(state: EvaluationState, call: Call) -> Value | None:
    columns = [items_of(state, value) for value in call.positional]
    if not columns or any(column is None or any(map(is_many, column)) for column in columns):
        return None
    rows: list[Value] = []
    for row in zip(*[column for column in columns if column is not None], strict=False):
        rows.append(Sequence(call.span, "tuple", list(row), [call.span] * len(row)))
    return state.computed_list(call.span, rows)


def as_map(state: EvaluationState, call: Call) -> Value | None:
    if len(call.positional) != 2:
        return None
    items = items_of(state, call.positional[1])
    if items is None:
        return None
    made = [item if is_many(item) else state.apply(call.positional[0], [item], call.span) for item in items]
    return state.computed_list(call.span, made)


def as_filter(state: EvaluationState, call: Call) -> Value | None:
    if len(call.positional) != 2:
        return None
    test, items = call.positional[0], items_of(state, call.positional[1])
    if items is None:
        return None
    kept: list[Value] = []
    for item in items:
        nothing = isinstance(test, Constant) and test.value is None
        holds = True if is_many(item) else truth(item if nothing else state.apply(test, [item], call.span))
        if holds:
            kept.append(item)
        elif holds is None:
            why = f"whether {state.quoted(call.span)} keeps an item is unknown"
            kept.append(state.unknown(call.span, why, many=True, options=(item,)))
    return state.computed_list(call.span, kept)


def as_chain(state: EvaluationState, call: Call) -> Value | None:
    """itertools.chain."""
    result: list[Value] = []
    for value in call.positional:
        items = items_of(state, value)
        result += [state.unknown(call.span, "it can't be evaluated", many=True)] if items is None else items
    return state.computed_list(call.span, result)


def as_flat_chain(state: EvaluationState, call: Call) -> Value | None:
    """itertools.chain.from_iterable, and sum(lists, [])."""
    outer = items_of(state, call.positional[0]) if call.positional else None
    if outer is None:
        return None
    result: list[Value] = []
    for value in outer:
        items = items_of(state, value)
        if items is None:
            return None
        result += items
    return state.computed_list(call.span, result)


def as_sum(state: EvaluationState, call: Call) -> Value | None:
    if len(call.positional) == 2 and isinstance(call.positional[1], Sequence):
        found = as_flat_chain(state, call)
        return (
            state.computed_list(call.span, call.positional[1].items + found.items)
            if isinstance(found, Sequence)
            else None
        )
    return plain_function(sum)(state, call)


def any_or_all(over: Callable[[list[bool]], bool]) -> Intrinsic:
    """any() and all()."""

    def intrinsic(state: EvaluationState, call: Call) -> Value | None:
        items = items_of(state, call.positional[0]) if call.positional else None
        if items is None:
            return None
        verdicts = [truth(item) for item in items]
        known = [verdict for verdict in verdicts if verdict is not None]
        is_decided = (over([True, False]) is not over([True]) and False in known) or (
            over([False, True]) and True in known
        )
        return Constant(call.span, over(known)) if len(known) == len(verdicts) or is_decided else None

    return intrinsic


def as_len(state: EvaluationState, call: Call) -> Value | None:
    value = call.positional[0] if call.positional else None
    if isinstance(value, Sequence) and value.is_complete:
        return Constant(call.span, len(value.items))
    if isinstance(value, MappingValue) and value.is_complete:
        return Constant(call.span, len(value.items))
    return Constant(call.span, len(value.text)) if isinstance(value, Text) else None


def as_next(state: EvaluationState, call: Call) -> Value | None:
    """next(): of a list that was made by a generator expression, its first item, which is taken out of it."""
    source = call.positional[0] if call.positional else None
    if not isinstance(source, Sequence) or (source.items and is_many(source.items[0])):
        return None
    if not source.items:
        return call.positional[1] if len(call.positional) > 1 else None
    first = source.items[0]
    take_item(state, source, Constant(call.span, 0), call.span)
    return first


ITERATOR_BUILTINS: Mapping[str, Intrinsic] = {
    **COLLECTION_BUILTINS,
    "zip": as_zip,
    "map": as_map,
    "filter": as_filter,
    "itertools.chain": as_chain,
    "itertools.chain.from_iterable": as_flat_chain,
    "any": any_or_all(any),
    "all": any_or_all(all),
    "len": as_len,
    "next": as_next,
    "sum": as_sum,
    "min": plain_function(min),
    "max": plain_function(max),
}
