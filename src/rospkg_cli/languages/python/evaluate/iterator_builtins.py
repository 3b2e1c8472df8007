"""Builtins that pick, join and ask about the items of what can be iterated."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from .collection_builtins import LISTING
from .iterables import items_of, many, pure
from .state import EvaluationState, Intrinsic
from .truthiness import truth
from .values import Call, Constant, Sequence, Text, Value
from .values import Mapping as MappingValue


def zipped(machine: EvaluationState, call: Call) -> Value | None:
    columns = [items_of(machine, value) for value in call.positional]
    if not columns or any(column is None or any(map(many, column)) for column in columns):
        return None
    rows: list[Value] = []
    for row in zip(*[column for column in columns if column is not None], strict=False):
        rows.append(Sequence(call.span, "tuple", list(row), [call.span] * len(row)))
    return machine.new_list(call.span, rows)


def mapped(machine: EvaluationState, call: Call) -> Value | None:
    if len(call.positional) != 2:
        return None
    items = items_of(machine, call.positional[1])
    if items is None:
        return None
    made = [item if many(item) else machine.apply(call.positional[0], [item], call.span) for item in items]
    return machine.new_list(call.span, made)


def filtered(machine: EvaluationState, call: Call) -> Value | None:
    if len(call.positional) != 2:
        return None
    test, items = call.positional[0], items_of(machine, call.positional[1])
    if items is None:
        return None
    kept: list[Value] = []
    for item in items:
        nothing = isinstance(test, Constant) and test.value is None
        holds = True if many(item) else truth(item if nothing else machine.apply(test, [item], call.span))
        if holds:
            kept.append(item)
        elif holds is None:
            why = f"whether {machine.shown(call.span)} keeps an item can't be told"
            kept.append(machine.unknown(call.span, why, many=True, options=(item,)))
    return machine.new_list(call.span, kept)


def chained(machine: EvaluationState, call: Call) -> Value | None:
    """itertools.chain."""
    result: list[Value] = []
    for value in call.positional:
        items = items_of(machine, value)
        result += [machine.unknown(call.span, "it can't be evaluated", many=True)] if items is None else items
    return machine.new_list(call.span, result)


def flattened(machine: EvaluationState, call: Call) -> Value | None:
    """itertools.chain.from_iterable, and sum(lists, [])."""
    outer = items_of(machine, call.positional[0]) if call.positional else None
    if outer is None:
        return None
    result: list[Value] = []
    for value in outer:
        items = items_of(machine, value)
        if items is None:
            return None
        result += items
    return machine.new_list(call.span, result)


def total(machine: EvaluationState, call: Call) -> Value | None:
    if len(call.positional) == 2 and isinstance(call.positional[1], Sequence):
        found = flattened(machine, call)
        return (
            machine.new_list(call.span, call.positional[1].items + found.items) if isinstance(found, Sequence) else None
        )
    return pure(sum)(machine, call)


def quantified(over: Callable[[list[bool]], bool]) -> Intrinsic:
    """any() and all()."""

    def intrinsic(machine: EvaluationState, call: Call) -> Value | None:
        items = items_of(machine, call.positional[0]) if call.positional else None
        if items is None:
            return None
        verdicts = [truth(item) for item in items]
        told = [verdict for verdict in verdicts if verdict is not None]
        settled = (over([True, False]) is not over([True]) and False in told) or (over([False, True]) and True in told)
        return Constant(call.span, over(told)) if len(told) == len(verdicts) or settled else None

    return intrinsic


def length(machine: EvaluationState, call: Call) -> Value | None:
    value = call.positional[0] if call.positional else None
    if isinstance(value, Sequence) and value.complete:
        return Constant(call.span, len(value.items))
    if isinstance(value, MappingValue) and not value.rest:
        return Constant(call.span, len(value.items))
    return Constant(call.span, len(value.text)) if isinstance(value, Text) else None


def first(machine: EvaluationState, call: Call) -> Value | None:
    """next(): of a list that was made by a generator expression, its first item."""
    items = items_of(machine, call.positional[0]) if call.positional else None
    if items is None or (items and many(items[0])):
        return None
    return items[0] if items else call.positional[1] if len(call.positional) > 1 else None


ITERATION: Mapping[str, Intrinsic] = {
    **LISTING,
    "zip": zipped,
    "map": mapped,
    "filter": filtered,
    "itertools.chain": chained,
    "itertools.chain.from_iterable": flattened,
    "any": quantified(any),
    "all": quantified(all),
    "len": length,
    "next": first,
    "sum": total,
    "min": pure(min),
    "max": pure(max),
}
