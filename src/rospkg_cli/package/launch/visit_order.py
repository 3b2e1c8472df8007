"""The actions of a Python launch file in the order in which launch visits them, with all that they are made of."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import AttributeValue, Call, Mapping, PartialText, Sequence, Value
from ...ros.launch_calls import ACTIONS
from .launch_classes import class_of
from .launch_evaluator import ENTRIES
from .launch_file import LaunchFile
from .python_events import ADDS, LATER

MAX_DEPTH = 20
MAX_VALUES = 20_000


def visited_actions(file: LaunchFile) -> list[Call]:
    """Return the actions of the description that a file returns, in order; none where the description is not known.

    Of a group there are its actions; those of event handlers and timers are parts of these.
    """
    evaluated = file.evaluated
    for function, value in (evaluated.returned or {}).values() if evaluated is not None else ():
        described = value.items[0] if isinstance(value, Sequence) and value.items else value
        is_entry = function.name in ENTRIES and isinstance(described, Call)
        if evaluated is not None and is_entry and isinstance(described, Call):
            given = described.get("initial_entities", 0)
            added = [call.arguments[0].value for call in evaluated.calls if adds_to(call, described)]
            return [each for value in (given, *added) if value is not None for each in actions_in(value, 0)]
    return []


def adds_to(call: Call, described: Call) -> bool:
    return call.callee in ADDS and call.receiver is described and bool(call.arguments) and call.is_certain


def actions_in(value: Value, depth: int) -> Iterator[Call]:
    if isinstance(value, Call) and class_of(value) == "GroupAction" and depth < MAX_DEPTH:
        given = value.get("actions", 0)
        yield from actions_in(given, depth + 1) if given is not None else ()
    elif isinstance(value, Call) and class_of(value) in ACTIONS:
        yield value
    elif isinstance(value, Sequence) and depth < MAX_DEPTH:
        for item in value.items:
            yield from actions_in(item, depth + 1)


def calls_of(value: Value, *, now: bool = False) -> Iterator[Call]:
    """Yield the calls that a value is made of, the value included; `now` leaves out what waits for an event."""
    waiting: list[tuple[Value, int]] = [(value, 0)]
    count = 0
    while waiting and count < MAX_VALUES:
        each, depth = waiting.pop()
        count += 1
        if isinstance(each, Call) and not (now and class_of(each) in LATER):
            yield each
        elif isinstance(each, Call):
            continue
        if depth < MAX_DEPTH:
            waiting += [(part, depth + 1) for part in parts_of(each)]


def parts_of(value: Value) -> list[Value]:
    match value:
        case Call():
            given = [argument.value for argument in value.arguments]
            return given if value.receiver is None else [value.receiver, *given]
        case Sequence():
            return list(value.items)
        case Mapping():
            return [part for pair in value.items.values() for part in pair]
        case PartialText():
            return list(value.parts)
        case AttributeValue():
            return [value.of]
    return []
