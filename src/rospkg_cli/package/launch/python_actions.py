"""What calls of a Python launch file make: nodes, includes, arguments, commands."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import Call, Mapping, Sequence, Text, Unknown, Value
from .launched_parts import Command, DeclaredArgument, Include, LaunchedNode, NodeKind, NodeParameters
from .python_to_text import text_of
from .text import LaunchText, Literal, unknown_text

NODES: dict[str, NodeKind] = {
    "Node": "node",
    "LifecycleNode": "lifecycle_node",
    "ComposableNodeContainer": "node_container",
    "ComposableNode": "composable_node",
    "ComposableLifecycleNode": "composable_node",
}


def argument_text(call: Call, name: str, place: int = 0) -> LaunchText:
    found = call.get(name, place)
    return unknown_text(call.span) if found is None else text_of(found)


def optional_text(call: Call, name: str, old: str = "") -> LaunchText | None:
    """Return an argument, by its name or by the one that it had before Galactic; None where it is absent."""
    found = call.get(name)
    found = call.get(old) if found is None and old else found
    return None if found is None or is_none(found) else text_of(found)


def is_none(value: Value) -> bool:
    return getattr(value, "value", 0) is None


def certain(call: Call) -> bool:
    return call.is_certain and call.get("condition") is None


def node_of(call: Call, kind: NodeKind) -> LaunchedNode:
    return LaunchedNode(
        kind,
        call.span,
        package=optional_text(call, "package"),
        executable=optional_text(call, "executable", "node_executable"),
        plugin=optional_text(call, "plugin", "node_plugin"),
        name=optional_text(call, "name", "node_name"),
        namespace=optional_text(call, "namespace", "node_namespace"),
        parameters=tuple(parameters_of(call.get("parameters"))),
        remappings=tuple(pairs_of(call.get("remappings"))),
        arguments=tuple(text_of(item) for name in ("arguments", "ros_arguments") for item in items_of(call.get(name))),
        is_certain=certain(call),
        is_complete=call.rest is None,
    )


def items_of(value: Value | None) -> Iterator[Value]:
    """Yield the items of a list, and what may be items of it."""
    if isinstance(value, Sequence):
        for item in value.items:
            if isinstance(item, Unknown) and item.is_many and item.options:
                yield from item.options
            else:
                yield item
    elif value is not None:
        yield value


def parameters_of(value: Value | None) -> Iterator[NodeParameters]:
    for item in items_of(value):
        if isinstance(item, Mapping):
            yield NodeParameters(item.span, None, tuple(values_of(item)), not item.rest)
        elif isinstance(item, Unknown):
            yield NodeParameters(item.span, None, (), False)
        else:
            yield NodeParameters(item.span, text_of(item))


def values_of(value: Mapping, around: str = "") -> Iterator[tuple[LaunchText, LaunchText]]:
    """Yield names and values of a dict of parameters; launch_ros joins the names of dicts in each other with dots."""
    for key, given in value.items.values():
        name = text_of(key)
        if around and name.literal is not None:
            name = LaunchText(name.span, (Literal(f"{around}.{name.literal}", name.span),))
        if isinstance(given, Mapping) and given.items and not given.rest and name.literal:
            yield from values_of(given, name.literal)
        else:
            yield name, text_of(given)


def pairs_of(value: Value | None) -> Iterator[tuple[LaunchText, LaunchText]]:
    """Yield the pairs of a dict, or of a list of pairs."""
    if isinstance(value, Mapping):
        yield from ((text_of(key), text_of(given)) for key, given in value.items.values())
        return
    for item in items_of(value):
        if isinstance(item, Sequence) and len(item.items) == 2:
            yield text_of(item.items[0]), text_of(item.items[1])


def include_of(call: Call) -> Include:
    given = call.get("launch_arguments", 1)
    is_known = given is None or (isinstance(given, Sequence) and given.is_complete) or isinstance(given, Mapping)
    return Include(
        call.span,
        argument_text(call, "launch_description_source"),
        tuple(pairs_of(given)),
        certain(call),
        is_known and call.rest is None,
    )


def argument_of(call: Call) -> DeclaredArgument:
    default = call.get("default_value", 1)
    choices = [item.text for item in items_of(call.get("choices")) if isinstance(item, Text)]
    return DeclaredArgument(
        call.span,
        argument_text(call, "name"),
        None if default is None or is_none(default) else text_of(default),
        tuple(choices),
        certain(call),
    )


def command_of(call: Call) -> Command:
    given = call.get("cmd")
    words = [text_of(item) for item in items_of(given)]
    return Command(call.span, tuple(words))
