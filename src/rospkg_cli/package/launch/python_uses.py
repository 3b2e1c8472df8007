"""The launch configurations that evaluated calls and values of a Python launch file use."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import AttributeValue, Call, Mapping, PartialText, Sequence, Unknown, Value
from ...ros.launch_calls import SIGNATURES
from .configuration_events import LaunchEvent, uses_of
from .launch_classes import class_of, named_arguments
from .python_to_text import substitution, text_of

MAX_DEPTH = 40


def uses_in(call: Call, but: tuple[str, ...] = ()) -> Iterator[LaunchEvent]:
    """Yield the uses in the arguments of a call, except some of them."""
    named = SIGNATURES.get(class_of(call))
    for name, argument in named_arguments(call, named) if named is not None else ():
        if name not in but:
            yield from uses_in_value(argument.value, 0)


def uses_in_value(value: Value, depth: int) -> Iterator[LaunchEvent]:
    """Yield the launch configurations that a value uses when it is performed."""
    if depth > MAX_DEPTH:
        return
    match value:
        case Call():
            found = substitution(value)
            if found is not None and found.name == "var":
                yield from uses_of(text_of(value))
            else:
                for given in (value.receiver, *[argument.value for argument in value.arguments]):
                    if given is not None:
                        yield from uses_in_value(given, depth + 1)
        case Sequence():
            for item in value.items:
                yield from uses_in_value(item, depth + 1)
        case Mapping():
            for key, item in value.items.values():
                yield from uses_in_value(key, depth + 1)
                yield from uses_in_value(item, depth + 1)
        case PartialText():
            for part in value.parts:
                yield from uses_in_value(part, depth + 1)
        case AttributeValue():
            yield from uses_in_value(value.of, depth + 1)
        case Unknown():
            for option in value.options:
                yield from uses_in_value(option, depth + 1)
