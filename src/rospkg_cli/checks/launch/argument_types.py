"""What is passed to the classes of launch, compared with the types that they take (launch_ros: normalize_parameters).

Each check gets an argument and how a sentence names it: "`msg` of `LogInfo`".
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from ...languages.python.evaluate.values import Argument, Call, Constant, PartialText, Sequence, Text, Unknown, Value
from ...languages.python.evaluate.values import Mapping as Dict
from ...package.launch.launch_classes import (
    class_of,
    is_condition,
    is_resolved_at_run_time,
    is_substitution,
    span_within,
    type_name,
    value_span,
)
from ...ros.launch_calls import ACTIONS, OUTPUTS, Kind
from ...source import Span
from ..fault import Fault, TextRepair, replacement
from .parameter_types import RAISES, parameters_faults
from .python_truth import shown_value

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


def condition_faults(argument: Argument, what: str) -> Iterator[Fault]:
    value = argument.value
    if is_substitution(value) or isinstance(value, Text | PartialText | Constant | Sequence | Dict):
        shown = shown_value(value) if is_substitution(value) else type_name(value)
        message = f"{what} takes IfCondition or UnlessCondition, not {shown}: the launch stops with "
        yield Fault(value_span(argument), f"{message}\"object has no attribute 'evaluate'\"")


def actions_faults(argument: Argument, what: str) -> Iterator[Fault]:
    """Launch takes a list of actions."""
    value = argument.value
    message = f"{what} takes a list of actions, not {type_name(value)}"
    if isinstance(value, Call) and (class_of(value) in ACTIONS or is_resolved_at_run_time(value)):
        yield Fault(value_span(argument), f"{message}: write `[…]` around it")
    elif isinstance(value, Text | Constant):
        yield Fault(value_span(argument), message)
    elif isinstance(value, Sequence):
        yield from action_list_faults(value, what)


def action_list_faults(value: Sequence, what: str) -> Iterator[Fault]:
    """Yield the items of a list that launch can't visit."""
    for item, place in zip(value.items, value.places, strict=True):
        component = isinstance(item, Call) and class_of(item) == "ComposableNode"
        if (
            is_resolved_at_run_time(item)
            or component
            or isinstance(item, Text | PartialText | Constant | Sequence | Dict)
        ):
            hint = "; put a `*` before it" if isinstance(item, Sequence) and item.kind != "set" else ""
            hint = "; a component needs a container" if component else hint
            message = f"{type_name(item)} is no action, and {what} takes a list of actions: the launch stops"
            yield Fault(place, message + hint)


def pairs_faults(argument: Argument, what: str) -> Iterator[Fault]:
    """Launch takes pairs of a name and a text."""
    value, place = argument.value, value_span(argument)
    if isinstance(value, Dict) and value.items:
        end = Span(value.span.end, value.span.end)
        repair = (
            TextRepair("write `.items()`", ((end, ".items()"),)) if value.is_display and value.span == place else None
        )
        message = f"{what} takes pairs of name and value, and a dict gives keys: add `.items()`"
        yield Fault(place, message, repair=repair)
    for item in value.items if isinstance(value, Sequence) else ():
        if isinstance(item, Dict | Text):
            message = f"{what} takes pairs of name and value, not {type_name(item)}: the launch stops"
            yield Fault(span_within(item, place), message)
        elif isinstance(item, Sequence) and len(item.items) == 2 and item.is_complete:
            inner = item.items[1]
            yield from no_text(inner, span_within(inner, place), f"a value of {what}")


def output_faults(argument: Argument, what: str) -> Iterator[Fault]:
    value = argument.value
    if isinstance(value, Text) and value.text not in OUTPUTS:
        known = ", ".join(f"`{name}`" for name in sorted(OUTPUTS))
        yield Fault(value_span(argument), f"{what} can't be `{value.text}`, only {known}: the node is not started")
    elif isinstance(value, Constant):
        yield Fault(value_span(argument), f"{what} takes a string, not {type_name(value)}: launch raises TypeError")


def period_faults(argument: Argument, what: str) -> Iterator[Fault]:
    value = argument.value
    if isinstance(value, Constant) and type(value.value) is int:
        message = f"{what} takes a float, and launch raises TypeError for {type_name(value)}"
        yield constant_fault(value, value_span(argument), message, f"{value.value}.0")


def remappings_faults(argument: Argument, what: str) -> Iterator[Fault]:
    """launch_ros takes a list of pairs, each a tuple."""
    value, place = argument.value, value_span(argument)
    if isinstance(value, Dict) and value.items:
        yield Fault(place, f"{what} takes a list of pairs, not a dict: {RAISES}; write `list({{…}}.items())`")
    if not isinstance(value, Sequence):
        return
    if any(isinstance(item, Text | Constant | Dict) for item in value.items):
        yield Fault(place, f"{what} takes a list of pairs `('from', 'to')`: {RAISES}")
        return
    for item in value.items:
        if isinstance(item, Sequence) and item.is_complete and (item.kind != "tuple" or len(item.items) != 2):
            found = f"{type_name(item)} of {len(item.items)}"
            yield Fault(span_within(item, place), f"{what} takes pairs `('from', 'to')`, and this is {found}: {RAISES}")


TYPE_CHECKS: Mapping[Kind, Callable[[Argument, str], Iterator[Fault]]] = {
    "text": text_faults,
    "words": words_faults,
    "paths": paths_faults,
    "condition": condition_faults,
    "actions": actions_faults,
    "pairs": pairs_faults,
    "output": output_faults,
    "period": period_faults,
    "parameters": parameters_faults,
    "remappings": remappings_faults,
}
