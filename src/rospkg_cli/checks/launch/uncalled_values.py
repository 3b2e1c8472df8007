"""Methods and functions that are passed to launch where their result is needed: `launch_arguments={…}.items`."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import (
    Argument,
    AttributeValue,
    Function,
    Mapping,
    PartialText,
    Sequence,
    Text,
    Value,
)
from ...package.launch.launch_classes import is_substitution, span_within, type_name, value_span
from ...ros.launch_calls import Kind
from ..fault import Fault

SINGLE: frozenset[Kind] = frozenset({"text", "paths", "condition", "pairs"})
LISTS: frozenset[Kind] = frozenset({"words", "paths", "actions", "parameters", "remappings"})
PERFORM = ".perform"
"""It takes the context, which only functions have that launch calls."""
RAISES = "the launch stops"
METHODS = {"dict": frozenset(dir(dict)), "str": frozenset(dir(str)), "list": frozenset(dir(list))}


def uncalled_faults(kind: Kind, argument: Argument, what: str) -> Iterator[Fault]:
    """Yield an argument, or an item of a list, that is a method or a function itself."""
    value, place = argument.value, value_span(argument)
    if kind in SINGLE | LISTS and (shown := uncalled(value)):
        takes = "pairs of name and value" if kind == "pairs" else "no function"
        yield Fault(place, f"{what} takes {takes}, and `{shown}` is not called: {RAISES}{advice(shown)}")
    items = zip(value.items, value.places, strict=True) if kind in LISTS and isinstance(value, Sequence) else ()
    for item, at in items:
        if shown := uncalled(item):
            said = f"an item of {what} is `{shown}` itself, which is not called: {RAISES}{advice(shown)}"
            yield Fault(span_within(item, at), said)


def advice(shown: str) -> str:
    return "" if shown == PERFORM else f"; write `{shown}()`"


def uncalled(value: Value) -> str:
    """Return the name of the method or function that a value is; "" for anything else."""
    if isinstance(value, Function):
        return "" if value.is_decorated or value.name in ("", "<lambda>", "lambda") else value.name
    if not isinstance(value, AttributeValue) or value.name.startswith("_"):
        return ""
    return f".{value.name}" if value.name in methods_of(value.of) else ""


def methods_of(owner: Value) -> frozenset[str]:
    match owner:
        case Mapping():
            return METHODS["dict"]
        case Text(is_path=False) | PartialText(is_path=False):
            return METHODS["str"]
        case Sequence() if type_name(owner) == "a list":
            return METHODS["list"]
    return frozenset({"perform"}) if is_substitution(owner) else frozenset()
