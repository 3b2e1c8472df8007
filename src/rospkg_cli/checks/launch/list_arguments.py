"""Arguments of launch classes that take lists of actions or of pairs (LCH014)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import Argument, Call, Constant, PartialText, Sequence, Text
from ...languages.python.evaluate.values import Mapping as Dict
from ...package.launch.launch_classes import class_of, is_resolved_at_run_time, span_within, type_name, value_span
from ...ros.launch_calls import ACTIONS
from ...source import Span
from ..fault import Fault, TextRepair
from .parameter_types import RAISES
from .text_arguments import no_text


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
