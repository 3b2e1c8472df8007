"""Launch events of single actions: what sets a launch configuration, and what an include passes on."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import Call, Constant, Mapping, Sequence, Value
from .configuration_events import LaunchEvent, file_name, passed_uses
from .python_to_text import text_of
from .python_uses import uses_in, uses_in_value


def defined_by(call: Call, name: str) -> Iterator[LaunchEvent]:
    argument = call.get("name", 0)
    literal = (text_of(argument).literal or "") if argument is not None else ""
    if name == "DeclareLaunchArgument":
        default = call.get("default_value")
        has_none = default is None or (isinstance(default, Constant) and default.value is None)
        yield LaunchEvent("declare", literal, call.span, has_none)
    elif name == "SetLaunchConfiguration":
        yield LaunchEvent("define", literal, call.span)
    elif name == "UnsetLaunchConfiguration":
        yield LaunchEvent("open")


def included(call: Call) -> Iterator[LaunchEvent]:
    """Yield the events of an include: what it passes is set one after the other, then the file is visited."""
    yield from uses_in(call, but=("launch_arguments",))
    given = call.get("launch_arguments", 1)
    if isinstance(given, Mapping):
        for key, value in given.items.values():
            yield from passed(key, value)
    elif isinstance(given, Sequence):
        for item in given.items:
            pair = item.items if isinstance(item, Sequence) and len(item.items) == 2 else None
            yield from passed(pair[0], pair[1]) if pair else [LaunchEvent("pass")]
    elif given is not None and not isinstance(given, Constant):
        yield LaunchEvent("pass")
    source = call.get("launch_description_source", 0)
    yield LaunchEvent("include", file_name(text_of(source)) if source is not None else "", call.span)


def passed(name: Value, value: Value) -> Iterator[LaunchEvent]:
    text = text_of(name).literal or ""
    yield from uses_in_value(name, 0)
    yield from passed_uses(uses_in_value(value, 0), text)
    yield LaunchEvent("pass", text, name.span)
