"""Builtins that make lists of what can be iterated: a part that can't be told stays in its place."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from ..unreadable import UnreadableError
from .bounds import MAX_ITEMS, LimitError
from .machine import Intrinsic, Machine
from .operators import truth
from .plain import NotPlainError, lift, plain
from .values import Call, Constant, Opened, Sequence, Text, Unknown, Value
from .values import Mapping as MappingValue


def items_of(machine: Machine, value: Value) -> list[Value] | None:
    """Return what a loop over a value sees; None where nothing of it is known."""
    match value:
        case Sequence():
            return list(value.items)
        case MappingValue():
            rest = [machine.unknown(value.span, each.why, many=True) for each in value.rest[:1]]
            return [key for key, _ in value.items.values()] + rest
        case Text() if not value.path:
            machine.tick(len(value.text))
            return [Text(value.span, char) for char in value.text]
        case Opened():
            left = read_rest(machine, value)
            return None if left is None else [Text(value.span, line) for line in left.splitlines(keepends=True)]
    return None


def read_rest(machine: Machine, opened: Opened) -> str | None:
    """Return what was not read yet, and take it as read; None where the file has no text."""
    try:
        text = machine.folder.files.source(opened.path).text
    except UnreadableError:
        return None
    machine.tick(len(text) // 100)
    rest, opened.at = text[opened.at :], len(text)
    return rest


def many(item: Value) -> bool:
    return isinstance(item, Unknown) and item.many


def as_list(machine: Machine, call: Call) -> Value | None:
    if not call.positional:
        return machine.new_list(call.span, [])
    items = items_of(machine, call.positional[0])
    return None if items is None else machine.new_list(call.span, items)


def as_tuple(machine: Machine, call: Call) -> Value | None:
    found = as_list(machine, call)
    if isinstance(found, Sequence):
        found.kind = "tuple"
    return found


def as_set(machine: Machine, call: Call) -> Value | None:
    found = as_list(machine, call)
    if not isinstance(found, Sequence):
        return None
    distinct: dict[Any, Value] = {}
    try:
        for item in found.items:
            distinct.setdefault(id(item) if many(item) else plain(item), item)
    except (NotPlainError, TypeError):
        return None
    return Sequence(call.span, "set", list(distinct.values()), [call.span] * len(distinct), born=found.born)


def as_dict(machine: Machine, call: Call) -> Value | None:
    result = MappingValue(call.span, born=len(machine.conditions))
    source = call.positional[0] if call.positional else None
    if isinstance(source, MappingValue):
        result.items.update(source.items)
        result.rest += source.rest
    elif source is not None:
        for pair in items_of(machine, source) or [source]:
            if not isinstance(pair, Sequence) or len(pair.items) != 2:
                return None
            try:
                result.items[plain(pair.items[0])] = (pair.items[0], pair.items[1])
            except (NotPlainError, TypeError):
                return None
    for argument in call.arguments:
        if argument.name:
            result.items[argument.name] = (Text(argument.span, argument.name), argument.value)
    return result


def as_range(machine: Machine, call: Call) -> Value | None:
    try:
        bounds = [value for value in map(plain, call.positional) if isinstance(value, int)]
        numbers = range(*bounds)
    except (NotPlainError, TypeError, ValueError):
        return None
    if len(bounds) != len(call.positional):
        return None
    if len(numbers) > MAX_ITEMS:
        raise LimitError(f"a range of more than {MAX_ITEMS} numbers")
    return machine.new_list(call.span, [Constant(call.span, number) for number in numbers])


def in_order(machine: Machine, call: Call) -> Value | None:
    items = items_of(machine, call.positional[0]) if call.positional else None
    if items is None:
        return None
    key = call.get("key")
    try:
        keyed = [(item, plain(machine.apply(key, [item], call.span) if key else item)) for item in items]
        reverse = call.get("reverse")
        keyed.sort(key=lambda pair: pair[1], reverse=bool(reverse and truth(reverse)))  # type: ignore[arg-type,return-value]
        items = [item for item, _ in keyed]
    except (NotPlainError, TypeError):
        return machine.new_list(call.span, items) if any(map(many, items)) else None
    return machine.new_list(call.span, items)


def backwards(machine: Machine, call: Call) -> Value | None:
    items = items_of(machine, call.positional[0]) if call.positional else None
    return None if items is None else machine.new_list(call.span, items[::-1])


def numbered(machine: Machine, call: Call) -> Value | None:
    items = items_of(machine, call.positional[0]) if call.positional else None
    start = call.get("start", 1) or Constant(call.span, 0)
    if items is None or any(map(many, items)) or not isinstance(start, Constant) or not isinstance(start.value, int):
        return None
    pairs: list[Value] = []
    for number, item in enumerate(items, start.value):
        pairs.append(Sequence(call.span, "tuple", [Constant(call.span, number), item], [call.span] * 2))
    return machine.new_list(call.span, pairs)


def zipped(machine: Machine, call: Call) -> Value | None:
    columns = [items_of(machine, value) for value in call.positional]
    if not columns or any(column is None or any(map(many, column)) for column in columns):
        return None
    rows: list[Value] = []
    for row in zip(*[column for column in columns if column is not None], strict=False):
        rows.append(Sequence(call.span, "tuple", list(row), [call.span] * len(row)))
    return machine.new_list(call.span, rows)


def mapped(machine: Machine, call: Call) -> Value | None:
    if len(call.positional) != 2:
        return None
    items = items_of(machine, call.positional[1])
    if items is None:
        return None
    made = [item if many(item) else machine.apply(call.positional[0], [item], call.span) for item in items]
    return machine.new_list(call.span, made)


def filtered(machine: Machine, call: Call) -> Value | None:
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


def chained(machine: Machine, call: Call) -> Value | None:
    """itertools.chain."""
    result: list[Value] = []
    for value in call.positional:
        items = items_of(machine, value)
        result += [machine.unknown(call.span, "it can't be evaluated", many=True)] if items is None else items
    return machine.new_list(call.span, result)


def flattened(machine: Machine, call: Call) -> Value | None:
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


def total(machine: Machine, call: Call) -> Value | None:
    if len(call.positional) == 2 and isinstance(call.positional[1], Sequence):
        found = flattened(machine, call)
        return (
            machine.new_list(call.span, call.positional[1].items + found.items) if isinstance(found, Sequence) else None
        )
    return pure(sum)(machine, call)


def quantified(over: Callable[[list[bool]], bool]) -> Intrinsic:
    """any() and all()."""

    def intrinsic(machine: Machine, call: Call) -> Value | None:
        items = items_of(machine, call.positional[0]) if call.positional else None
        if items is None:
            return None
        verdicts = [truth(item) for item in items]
        told = [verdict for verdict in verdicts if verdict is not None]
        settled = (over([True, False]) is not over([True]) and False in told) or (over([False, True]) and True in told)
        return Constant(call.span, over(told)) if len(told) == len(verdicts) or settled else None

    return intrinsic


def length(machine: Machine, call: Call) -> Value | None:
    value = call.positional[0] if call.positional else None
    if isinstance(value, Sequence) and value.complete:
        return Constant(call.span, len(value.items))
    if isinstance(value, MappingValue) and not value.rest:
        return Constant(call.span, len(value.items))
    return Constant(call.span, len(value.text)) if isinstance(value, Text) else None


def first(machine: Machine, call: Call) -> Value | None:
    """next(): of a list that was made by a generator expression, its first item."""
    items = items_of(machine, call.positional[0]) if call.positional else None
    if items is None or (items and many(items[0])):
        return None
    return items[0] if items else call.positional[1] if len(call.positional) > 1 else None


def pure(function: Callable[..., Any]) -> Intrinsic:
    """Return the intrinsic of a function over plain values that is cheap for whatever it gets."""

    def intrinsic(machine: Machine, call: Call) -> Value | None:
        try:
            positional = [plain(value) for value in call.positional]
            named = {argument.name: plain(argument.value) for argument in call.arguments if argument.name}
            return lift(function(*positional, **named), call.span)
        except (NotPlainError, TypeError, ValueError, LookupError, AttributeError, ArithmeticError):
            return None

    return intrinsic


ITERATION: Mapping[str, Intrinsic] = {
    "list": as_list,
    "tuple": as_tuple,
    "set": as_set,
    "frozenset": as_set,
    "dict": as_dict,
    "collections.OrderedDict": as_dict,
    "iter": as_list,
    "range": as_range,
    "sorted": in_order,
    "reversed": backwards,
    "enumerate": numbered,
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
