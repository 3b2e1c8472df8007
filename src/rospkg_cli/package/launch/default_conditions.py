"""What a launch file does only where an argument has another value than its default."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import suppress

from ...languages.python.evaluate.values import Call, Function, Sequence, Value
from ...languages.python.nodes import nodes_of_kind
from ...light_dataclasses import dataclass
from ...source import Span
from .asked_defaults import Defaults
from .default_branches import untaken_branches
from .default_choices import untaken_choices
from .default_texts import condition_by_default, text_by_default, truth_of
from .entity import Entity
from .launch_classes import class_of
from .launch_file import LaunchFile
from .plain_values import NotKnownError
from .substitution import SubstitutionError, parse_text

MAX_DEPTH = 8
HOLDING = ("actions", "entities", "composable_node_descriptions", "on_exit", "on_start", "on_completion", "on_shutdown")
"""Arguments that hold what an action starts, now or later."""
NONE_INCLUDED: Mapping[str, str] = {}


@dataclass(frozen=True, slots=True)
class OffByDefault:
    """A part of a launch file, and the argument or variable that turns it on: `sim:=true`."""

    span: Span
    argument: str
    is_branch: bool = False
    """Whether Python itself does not run it; else Python makes it, and launch does not visit it."""

    def turns_off(self, span: Span, *, is_late: bool) -> bool:
        """Return whether a use at a span is not reached: by Python, or by launch, which comes late."""
        return self.span.holds(span) and (is_late or self.is_branch)


def off_by_default(file: LaunchFile, included: Mapping[str, str] = NONE_INCLUDED) -> Iterator[OffByDefault]:
    """Yield what is not done for the defaults of the file's arguments: actions, entities, branches of Python.

    Args:
        included: the defaults of arguments that included files alone declare.
    """
    defaults = {**included, **usual_values(file)}
    for call in file.evaluated.calls if file.evaluated else ():
        condition = call.get("condition")
        found = false_call(condition, defaults) if isinstance(condition, Call) else ""
        for span in spans_of(call) if found else ():
            yield OffByDefault(span, found)
        if found and (function := function_of(call, file)):
            yield OffByDefault(function, found, is_branch=True)
    if file.python is not None:
        yield from (OffByDefault(*each, is_branch=True) for each in untaken_branches(file.python, defaults))
        yield from (OffByDefault(*each) for each in untaken_choices(file.python, defaults))
    if file.root is not None:
        yield from off_entities(file.root, defaults)


def usual_values(file: LaunchFile) -> Mapping[str, str]:
    """Return the defaults of the arguments that are declared once and that the file does not set itself.

    They may depend on those before them, or on a variable of the environment that has a default.
    """
    declared = Counter(each.name.literal for each in file.arguments)
    assigned = {each.literal for each in file.assigned}
    found: dict[str, str] = {}
    for each in file.arguments:
        name = each.name.literal
        if name and declared[name] == 1 and name not in assigned and each.default is not None:
            with suppress(NotKnownError):
                found[name] = text_by_default(each.default, Defaults(found))
    return found


def function_of(call: Call, file: LaunchFile) -> Span | None:
    """Return the function that an OpaqueFunction alone calls."""
    given = call.get("function", 0) if class_of(call) == "OpaqueFunction" else None
    if not isinstance(given, Function) or file.python is None:
        return None
    named = Counter(node.id for node in nodes_of_kind(file.python.tree, ast.Name))
    return file.python.span(given.node) if named[given.name] == 1 else None


def off_entities(entity: Entity, arguments: Mapping[str, str]) -> Iterator[OffByDefault]:
    for name in ("if", "unless"):
        written = entity.attributes.get(name)
        defaults = Defaults(arguments)
        try:
            holds = written is None or truth_of(text_by_default(parse_text(written), defaults)) is (name == "if")
        except (NotKnownError, SubstitutionError):
            continue
        if not holds and (found := defaults.other()):
            yield OffByDefault(entity.span, found)
            return
    for child in entity.children:
        yield from off_entities(child, arguments)


def spans_of(call: Call) -> Iterator[Span]:
    """Yield the spans of an action, and of all that it starts: the actions in its lists, components, what follows."""
    waiting: list[tuple[Value, int]] = [(call, 0)]
    while waiting:
        value, depth = waiting.pop()
        if isinstance(value, Call):
            yield value.span
            given = [value.get(name) for name in HOLDING]
            given += [value.get("actions", 0)] if class_of(value) == "GroupAction" else []
            given += [value.get("event_handler", 0)] if class_of(value) == "RegisterEventHandler" else []
            waiting += [(each, depth + 1) for each in given if each is not None] if depth < MAX_DEPTH else []
        elif isinstance(value, Sequence) and depth < MAX_DEPTH:
            waiting += [(item, depth + 1) for item in value.items]


def false_call(condition: Call, arguments: Mapping[str, str]) -> str:
    """Return the argument that makes a condition true which is false by default; "" for any other condition."""
    defaults = Defaults(arguments)
    try:
        return "" if condition_by_default(condition, defaults) else defaults.other()
    except NotKnownError:
        return ""
