"""Methods of dicts, which change them in place: for certain, or perhaps."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from ....source import Span
from .conversion import NotPlainError, plain
from .limits import ITEM, spend
from .list_methods import unfollowed
from .state import EvaluationState
from .values import Call, Constant, Sequence, Text, Value
from .values import Mapping as MappingValue


def get(machine: EvaluationState, value: MappingValue, call: Call) -> Value | None:
    try:
        found = value.items.get(plain(call.positional[0]))
    except (NotPlainError, IndexError, TypeError):
        return None
    if value.rest:
        return None
    if found:
        return found[1]
    return call.positional[1] if len(call.positional) > 1 else Constant(call.span, None)


def views(machine: EvaluationState, value: MappingValue, call: Call) -> Value | None:
    spend(len(value.items) * ITEM)
    match call.callee:
        case "keys":
            found: list[Value] = [key for key, _ in value.items.values()]
        case "values":
            found = [item for _, item in value.items.values()]
        case _:
            found = [Sequence(call.span, "tuple", list(pair), [call.span] * 2) for pair in value.items.values()]
    rest: list[Value] = [machine.unknown(call.span, each.why, many=True) for each in value.rest[:1]]
    return machine.new_list(call.span, found + rest)


def set_item(machine: EvaluationState, value: MappingValue, key: Value, item: Value, span: Span) -> None:
    """`mapping[key] = item`, for certain or perhaps."""
    machine.tick()
    try:
        at = plain(key)
        hash(at)
    except (NotPlainError, TypeError):
        machine.spoil(value, span, f"{machine.shown(span)} can't be evaluated")
        return
    if len(machine.conditions) > value.born:
        old = value.items[at][1:] if at in value.items else ()
        item = machine.unknown(span, machine.conditions[-1], options=(*old, item))
    value.items[at] = (key, item)


def update(machine: EvaluationState, value: MappingValue, call: Call) -> Value | None:
    source = call.positional[0] if call.positional else None
    if isinstance(source, MappingValue):
        for key, item in list(source.items.values()):
            set_item(machine, value, key, item, key.span)
        value.rest += source.rest
    elif source is not None or call.rest:
        return unfollowed(machine, value, call)
    for argument in call.arguments:
        if argument.name:
            set_item(machine, value, Text(argument.span, argument.name), argument.value, argument.span)
    return Constant(call.span, None)


def setdefault(machine: EvaluationState, value: MappingValue, call: Call) -> Value | None:
    try:
        found = value.items.get(plain(call.positional[0]))
    except (NotPlainError, IndexError, TypeError):
        return unfollowed(machine, value, call)
    if found:
        return found[1]
    if value.rest:
        return unfollowed(machine, value, call)
    default = call.positional[1] if len(call.positional) > 1 else Constant(call.span, None)
    set_item(machine, value, call.positional[0], default, call.span)
    return default


def pop_key(machine: EvaluationState, value: MappingValue, call: Call) -> Value | None:
    found = get(machine, value, call)
    if found is None or len(machine.conditions) > value.born:
        return unfollowed(machine, value, call)
    value.items.pop(plain(call.positional[0]), None)
    return found


def copied_dict(machine: EvaluationState, value: MappingValue, call: Call) -> Value | None:
    spend(len(value.items) * ITEM)
    return replace(value, items=dict(value.items), rest=list(value.rest), born=len(machine.conditions))


DICTS: Mapping[str, Callable[[EvaluationState, MappingValue, Call], Value | None]] = {
    "get": get,
    "keys": views,
    "values": views,
    "items": views,
    "update": update,
    "setdefault": setdefault,
    "pop": pop_key,
    "copy": copied_dict,
}
