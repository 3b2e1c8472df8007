"""Arguments of launch classes that take texts, lists of texts or lists of paths (LCH014)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import Argument, Call, Constant, PartialText, Sequence, Text, Unknown, Value
from ...package.launch.launch_classes import class_of, is_condition, is_substitution, type_name, value_span
from ...ros.launch_calls import ACTIONS
from ...source import Span
from ..fault import Fault, replacement

REFUSED = "launch older than January 2026"
"""launch 1.0.14, 3.4.10, 3.8.7 and later, of all supported distributions, take a Path for a text (ros2/launch#873)."""


def constant_fault(value: Constant, place: Span, message: str, better: str) -> Fault:
    """Return the fault of a constant, with a repair where it is written at the place itself."""
    return Fault(place, message, repair=replacement(place, better) if better and value.span == place else None)


def is_path(value: Value) -> bool:
    """Return whether a value is a pathlib.Path; what PathSubstitution makes is a substitution."""
    if isinstance(value, PartialText) and is_substitution(value.parts[0]):
        return False
    return isinstance(value, Text | PartialText) and value.is_path


def text_faults(argument: Argument, what: str) -> Iterator[Fault]:
    """Launch takes a str, a substitution, or a list of these."""
    yield from no_text(argument.value, value_span(argument), what)


def no_text(value: Value, place: Span, what: str) -> Iterator[Fault]:
    quoted = f"'{value.value}'" if isinstance(value, Constant) and value.value is not None else ""
    if isinstance(value, Sequence):
        for item, at in zip(value.items, value.places, strict=True):
            if isinstance(item, Constant | Unknown):
                yield from no_text(item, at, what)
    elif isinstance(value, Unknown):
        defaults = [each for each in value.options if isinstance(each, Constant)]
        if defaults and len(defaults) == len(value.options):
            name = type_name(defaults[0])
            message = f"{what} takes a string, and {value.why}: then this is {name}, and launch raises TypeError"
            yield Fault(value.span, message, "warning")
    elif isinstance(value, Constant) or is_condition(value) or (isinstance(value, Call) and class_of(value) in ACTIONS):
        message = f"{what} takes a string or a substitution, and {type_name(value)} is neither: launch raises TypeError"
        if isinstance(value, Constant):
            yield constant_fault(value, place, message, quoted)
        else:
            yield Fault(place, message)
    elif is_path(value):
        yield Fault(place, f"{what} is a pathlib.Path: {REFUSED} raises TypeError; use str()", "info")


def words_faults(argument: Argument, what: str) -> Iterator[Fault]:
    """Launch takes a list of texts."""
    value = argument.value
    if isinstance(value, Text):
        message = f"{what} takes a list: each letter of a string becomes an argument of its own"
        yield Fault(value_span(argument), message)
    elif isinstance(value, Sequence):
        if value.kind == "set" and len(value.items) > 1:
            message = (
                f"{what} is a set, and a set has no order: the words come in another one at each start; write `[…]`"
            )
            yield Fault(value_span(argument), message, "warning")
        for item, place in zip(value.items, value.places, strict=True):
            yield from no_text(item, place, f"each item of {what}")
    elif isinstance(value, Constant) or is_substitution(value):
        yield Fault(value_span(argument), f"{what} takes a list, not {type_name(value)}: Python raises TypeError")


def paths_faults(argument: Argument, what: str) -> Iterator[Fault]:
    """Launch takes a list; releases before the middle of 2025 took a lone text as well."""
    value, place = argument.value, value_span(argument)
    if isinstance(value, Text | PartialText) and not is_path(value):
        if isinstance(value, PartialText) or len(value.text) > 1:
            message = f"{what} takes a list: the letters of a string are joined, one by one; write `[…]` around it"
            yield Fault(place, message, "warning")
    elif is_substitution(value):
        message = f"{what} takes a list: launch raises TypeError for one substitution since the middle of 2025"
        yield Fault(place, f"{message}; write `[…]` around it", "warning")
    else:
        yield from text_faults(argument, what)
