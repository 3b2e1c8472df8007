"""The order of events in a Python launch file: that of the launch description which it returns."""

from __future__ import annotations

import sys
from collections.abc import Iterator

from ...languages.python.evaluate.values import (
    Call,
    Constant,
    Function,
    Mapping,
    Sequence,
    Text,
    Unknown,
    Value,
)
from ...ros.launch_calls import ACTIONS
from .action_events import defined_by, included
from .configuration_events import LaunchEvent
from .configuration_lookups import DICT, has_other_use, lookups
from .launch_classes import class_of
from .launch_evaluator import ENTRIES, LaunchEvaluator
from .python_to_text import text_of
from .python_uses import MAX_DEPTH, uses_in, uses_in_value

LATER = frozenset({"RegisterEventHandler", "TimerAction", "RosTimer", "ROSTimer"})
ADDS = frozenset({"add_action", "add_entity"})
PERFORMS = frozenset({"perform", "perform_substitution"})
HARMLESS = (sys.stdlib_module_names | {"launch_testing", "print"}) - {"functools", "itertools"}
"""Where calls come from that declare nothing, whatever they return."""

MAX_VISITS = 50_000
"""Of actions: a function that launch calls may return itself, several times."""


def python_events(evaluator: LaunchEvaluator) -> tuple[LaunchEvent, ...] | None:
    """Return the events of a file; None where the description that it returns is unknown."""
    for function, value in evaluator.results.values():
        if function.name in ENTRIES and function.scope is evaluator.scope:
            described = value.items[0] if isinstance(value, Sequence) and value.items else value
            if isinstance(described, Call) and class_of(described) == "LaunchDescription":
                order = ExecutionOrder(evaluator)
                return (*order.description(described, 0), LaunchEvent("later"), *order.deferred)
    return None


class ExecutionOrder:
    def __init__(self, evaluator: LaunchEvaluator) -> None:
        self.evaluator = evaluator
        self.deferred: list[LaunchEvent] = []
        """What timers and event handlers do."""
        self.visits = 0
        self.performed = [call for call in evaluator.calls if call.is_certain and call.callee in PERFORMS]
        self.added: dict[int, list[Value]] = {}
        for call in evaluator.calls:
            if call.callee in ADDS and call.receiver is not None and call.arguments:
                self.added.setdefault(id(call.receiver), []).append(call.arguments[0].value)

    def description(self, call: Call, depth: int) -> Iterator[LaunchEvent]:
        first = call.get("initial_entities", 0)
        if first is not None:
            yield from self.several(first, depth)
        for each in self.added.get(id(call), ()):
            yield from self.visit(each, depth + 1)

    def several(self, value: Value, depth: int) -> Iterator[LaunchEvent]:
        if isinstance(value, Sequence):
            for item in value.items if self.visits <= MAX_VISITS else ():
                yield from self.visit(item, depth + 1)
        else:
            yield from self.visit(value, depth + 1)

    def visit(self, value: Value, depth: int) -> Iterator[LaunchEvent]:
        """Yield the events of an action."""
        self.visits += 1
        if depth > MAX_DEPTH or self.visits > MAX_VISITS:
            yield LaunchEvent("open")
        elif isinstance(value, Unknown):
            for option in value.options:
                yield from self.visit(option, depth + 1)
            if not value.options:
                yield LaunchEvent("open")
        elif isinstance(value, Sequence):
            yield from self.several(value, depth)
        elif isinstance(value, Call) and class_of(value) in ACTIONS:
            yield from self.action(value, class_of(value), depth)
        elif isinstance(value, Call) and class_of(value) == "LaunchDescription":
            yield from self.description(value, depth + 1)
        elif not isinstance(value, Constant | Text):
            yield from uses_in_value(value, 0)
            if not (isinstance(value, Call) and value.callee.partition(".")[0] in HARMLESS):
                yield LaunchEvent("open")

    def action(self, call: Call, name: str, depth: int) -> Iterator[LaunchEvent]:
        if name == "GroupAction":
            yield from self.group(call, depth)
        elif name == "OpaqueFunction":
            yield from self.opaque(call, depth)
        elif name in LATER:
            yield from uses_in(call, but=("actions", "event_handler"))
            handler = call.get("actions") or call.get("event_handler", 0)
            self.deferred += list(self.handled(handler, depth))
        elif name == "IncludeLaunchDescription":
            yield from included(call)
        else:
            yield from uses_in(call)
            yield from defined_by(call, name)

    def handled(self, value: Value | None, depth: int) -> Iterator[LaunchEvent]:
        if isinstance(value, Call) and class_of(value).startswith("On"):
            for argument in value.arguments:
                if argument.name != "target_action":
                    yield from self.several(argument.value, depth)
        elif value is not None:
            yield from self.several(value, depth)

    def group(self, call: Call, depth: int) -> Iterator[LaunchEvent]:
        yield from uses_in(call, but=("actions",))
        scoped = call.get("scoped")
        alone = not (isinstance(scoped, Constant) and scoped.value is False)
        if alone:
            yield LaunchEvent("push")
        given = call.get("launch_configurations")
        for key, _ in given.items.values() if isinstance(given, Mapping) else ():
            yield LaunchEvent("pass", text_of(key).literal or "", key.span)
        actions = call.get("actions", 0)
        if actions is not None:
            yield from self.several(actions, depth)
        if alone:
            yield LaunchEvent("pop")

    def opaque(self, call: Call, depth: int) -> Iterator[LaunchEvent]:
        """Yield the events of a function that launch calls: those in its body and those of its result."""
        yield from uses_in(call, but=("function",))
        function = call.get("function", 0)
        if not isinstance(function, Function):
            yield LaunchEvent("open")
            return
        for each in self.performed if self.visits <= MAX_VISITS else ():
            if function.span.contains(each.span):
                yield from uses_in_value(each, 0)
        if DICT in self.evaluator.file.source.text:
            yield from lookups(function.node, self.evaluator.file)
        _, value = self.evaluator.results.get(id(function.node), (None, None))
        if value is not None:
            yield from self.visit(value, depth + 1)
        if DICT in self.evaluator.file.source.text and has_other_use(self.evaluator.file):
            yield LaunchEvent("open")
