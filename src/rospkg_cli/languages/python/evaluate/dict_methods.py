"""Methods of dicts, which change them in place, certainly or possibly."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping

from ....light_dataclasses import replace
from ....source import Span
from .conversion import NoPythonValueError, to_python
from .iterables import as_doubtful, is_many, items_of
from .limits import ITEM, spend
from .list_methods import mark_unknown
from .state import EvaluationState
from .values import Call, Constant, Sequence, Text, Unknown, Value
from .values import Mapping as MappingValue


def get(state: EvaluationState, value: MappingValue, call: Call) -> Value | None:
    try:
        found = value.items.get(to_python(call.positional[0]))
    except (NoPythonValueError, IndexError, TypeError):
        return None
    if value.rest:
        return None
    default = call.positional[1] if len(call.positional) > 1 else Constant(call.span, None)
    if found:
        return one_of(state, found[1], default, call.span)
    return default


def one_of(state: EvaluationState, found: Value, default: Value, span: Span) -> Value:
    """Return a value of a dict, or the default too where the key is only perhaps there."""
    if isinstance(found, Unknown) and found.is_many:
        return state.unknown(span, found.why, options=(*found.options, default))
    return found


def views(state: EvaluationState, value: MappingValue, call: Call) -> Value | None:
    spend(len(value.items) * ITEM)
    match call.callee:
        case "keys":
            return state.computed_list(call.span, items_of(state, value) or [])
        case "values":
            found: list[Value] = [item for _, item in value.items.values()]
        case _:
            found = [pair_of(key, item, call.span) for key, item in value.items.values()]
    rest: list[Value] = [state.unknown(call.span, each.why, many=True) for each in value.rest[:1]]
    return state.computed_list(call.span, found + rest)


def pair_of(key: Value, item: Value, span: Span) -> Value:
    options = item.options if isinstance(item, Unknown) else ()
    pairs = tuple(Sequence(span, "tuple", [key, each], [span] * 2) for each in options)
    return as_doubtful(item, pairs) or Sequence(span, "tuple", [key, item], [span] * 2)


def set_item(state: EvaluationState, value: MappingValue, key: Value, item: Value, span: Span) -> None:
    """`mapping[key] = item`, certainly or possibly."""
    state.tick()
    try:
        at = to_python(key)
        hash(at)
    except (NoPythonValueError, TypeError):
        state.mark_unknown(value, span, f"{state.quoted(span)} can't be evaluated")
        return
    if len(state.conditions) > value.open_conditions:
        item = state.unknown(span, state.conditions[-1], many=True, options=(item,))
    put(value, at, key, item)


def put(value: MappingValue, at: Hashable, key: Value, item: Value) -> None:
    """Put an item into a dict; one that is only perhaps there (`is_many`) leaves what was there possible."""
    old = value.items[at][1] if at in value.items else None
    if old is not None and isinstance(item, Unknown) and item.is_many:
        options = old.options if isinstance(old, Unknown) and old.is_many else (old,)
        item = replace(item, is_many=is_many(old), options=(*options, *item.options))
    value.items[at] = (key, item)


def merge(value: MappingValue, source: MappingValue) -> None:
    """Put all that a dict holds into another: `{**a, **b}`."""
    spend(len(source.items) * ITEM)
    for at, (key, item) in source.items.items():
        put(value, at, key, item)
    value.rest += source.rest


def update(state: EvaluationState, value: MappingValue, call: Call) -> Value | None:
    source = call.positional[0] if call.positional else None
    if isinstance(source, MappingValue):
        for key, item in list(source.items.values()):
            set_item(state, value, key, item, key.span)
        value.rest += source.rest
    elif source is not None or call.rest:
        return mark_unknown(state, value, call)
    for argument in call.arguments:
        if argument.name:
            set_item(state, value, Text(argument.span, argument.name), argument.value, argument.span)
    return Constant(call.span, None)


def setdefault(state: EvaluationState, value: MappingValue, call: Call) -> Value | None:
    try:
        found = value.items.get(to_python(call.positional[0]))
    except (NoPythonValueError, IndexError, TypeError):
        return mark_unknown(state, value, call)
    if found:
        return found[1]
    if value.rest:
        return mark_unknown(state, value, call)
    default = call.positional[1] if len(call.positional) > 1 else Constant(call.span, None)
    set_item(state, value, call.positional[0], default, call.span)
    return default


def pop_key(state: EvaluationState, value: MappingValue, call: Call) -> Value | None:
    found = get(state, value, call)
    if found is None or len(state.conditions) > value.open_conditions:
        return mark_unknown(state, value, call)
    value.items.pop(to_python(call.positional[0]), None)
    return found


def copy_dict(state: EvaluationState, value: MappingValue, call: Call) -> Value | None:
    spend(len(value.items) * ITEM)
    return replace(value, items=dict(value.items), rest=list(value.rest), open_conditions=len(state.conditions))


DICT_METHODS: Mapping[str, Callable[[EvaluationState, MappingValue, Call], Value | None]] = {
    "get": get,
    "keys": views,
    "values": views,
    "items": views,
    "update": update,
    "setdefault": setdefault,
    "pop": pop_key,
    "copy": copy_dict,
}
