"""Read a Python launch file by evaluating it: what it builds, as far as its own text tells."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator

from ...source import Span
from ..evaluate.evaluator import Evaluator
from ..evaluate.folder import Folder
from ..evaluate.values import Call, Class, Function, Mapping, Scope, Sequence, Text, Unknown, Value
from ..python import PythonFile
from .file import (
    Command,
    DeclaredArgument,
    Include,
    LaunchedNode,
    LaunchFile,
    NodeKind,
    Parameters,
)
from .text import LaunchText, Substitution
from .values import class_of, substitution, text_of

NODES: dict[str, NodeKind] = {
    "Node": "node",
    "LifecycleNode": "lifecycle_node",
    "ComposableNodeContainer": "node_container",
    "ComposableNode": "composable_node",
    "ComposableLifecycleNode": "composable_node",
}
ENTRIES = ("generate_launch_description", "generate_test_description")
"""What launch and launch_testing call."""

MISSING = frozenset({"PackageNotFoundError", "LookupError", "KeyError", "Exception", "BaseException"})
"""What ament_index raises where a package is not there, and what takes it."""


class LaunchEvaluator(Evaluator):
    """An evaluator that remembers which functions it has been in."""

    def __init__(self, file: PythonFile, folder: Folder) -> None:
        super().__init__(file, folder, name="launch_file")
        self.entered: set[int] = set()
        self.active: list[int] = []

    def run(self, function: Function, call: Call) -> Value:
        """Run a function; one that calls itself on a condition that can't be told has no end that could be found."""
        node = id(function.node)
        if node in self.active and not self.certain:
            return self.unknown(call.span, f"`{function.name}` calls itself")
        self.entered.add(node)
        self.active.append(node)
        try:
            return super().run(function, call)
        finally:
            self.active.pop()

    def run_all(self) -> None:
        """Run the file, what launch calls of it, what that hands over, and at last every function left."""
        self.run_file()
        for name in ENTRIES:
            self.enter(self.get(name))
        done = 0
        while done < len(self.calls):
            call, done = self.calls[done], done + 1
            if class_of(call) == "OpaqueFunction":
                self.enter(call.get("function", 0))
        for function in list(functions_in(self.scope)):
            self.enter(function)

    def enter(self, function: Value | None) -> None:
        if isinstance(function, Function) and id(function.node) not in self.entered:
            self.call(function)


def functions_in(scope: Scope) -> Iterator[Function]:
    """Yield the functions of a file, and the methods of its classes."""
    for value in list(scope.names.values()):
        if isinstance(value, Function):
            yield value
        elif isinstance(value, Class):
            yield from functions_in(value.scope)


def read_python_launch(file: PythonFile, folder: Folder) -> LaunchFile:
    evaluator = LaunchEvaluator(file, folder)
    evaluator.run_all()
    calls = list(once(evaluator.calls))
    of = {name: [call for call in calls if class_of(call) == name] for name in {class_of(call) for call in calls}}
    every = (node_of(call, kind) for name, kind in NODES.items() for call in of.get(name, ()))
    return LaunchFile(
        file.source,
        "python",
        nodes=tuple(sorted(every, key=lambda node: node.span)),
        includes=tuple(map(include_of, of.get("IncludeLaunchDescription", ()))),
        arguments=tuple(map(argument_of, of.get("DeclareLaunchArgument", ()))),
        commands=tuple(map(command_of, [*of.get("ExecuteProcess", ()), *of.get("ExecuteLocal", ())])),
        substitutions=tuple(found for call in calls if (found := substitution(call)) is not None),
        assigned=tuple(argument_text(call, "name") for call in of.get("SetLaunchConfiguration", ())),
        complete=not evaluator.gave_up,
        entry=any(has_name(file, evaluator, name) for name in ENTRIES),
        imports=file.imports,
        guarded=tuple(guarded_in(file)),
    )


def has_name(file: PythonFile, evaluator: Evaluator, name: str) -> bool:
    """Return whether a file defines a name, may have it from elsewhere, or is a program that needs none."""
    told = not (file.stars or file.dynamic or "__main__" in file.source.text)
    return not told or name in file.definitions or evaluator.get(name) is not None


def guarded_in(file: PythonFile) -> Iterator[Span]:
    """Yield the bodies of `try` whose handlers take what a missing package raises."""
    for node in ast.walk(file.tree):
        if isinstance(node, ast.Try) and any(catches_missing(handler) for handler in node.handlers):
            yield Span(file.span(node.body[0]).start, file.span(node.body[-1]).end)


def catches_missing(handler: ast.ExceptHandler) -> bool:
    return handler.type is None or any(
        (isinstance(each, ast.Name) and each.id in MISSING)
        or (isinstance(each, ast.Attribute) and each.attr in MISSING)
        for each in ast.walk(handler.type)
    )


def once(calls: Iterable[Call]) -> Iterator[Call]:
    """Yield calls without those that say the same at the same place: loops come by several times."""
    seen = set()
    for call in calls:
        key = (call.span, call.callee, tuple((a.name, shown(a.value)) for a in call.arguments), call.certain)
        if key not in seen:
            seen.add(key)
            yield call


def shown(value: Value) -> object:
    return value.text if isinstance(value, Text) else value.span


def argument_text(call: Call, name: str, place: int = 0) -> LaunchText:
    found = call.get(name, place)
    return LaunchText(call.span, (Substitution("?", (), call.span),)) if found is None else text_of(found)


def optional_text(call: Call, name: str, old: str = "") -> LaunchText | None:
    """Return an argument, by its name or by the one that it had before Galactic; None where it is not given."""
    found = call.get(name)
    found = call.get(old) if found is None and old else found
    return None if found is None or is_none(found) else text_of(found)


def is_none(value: Value) -> bool:
    return getattr(value, "value", 0) is None


def certain(call: Call) -> bool:
    return call.certain and call.get("condition") is None


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
        certain=certain(call),
        complete=call.rest is None,
    )


def items_of(value: Value | None) -> Iterator[Value]:
    """Yield the items of a list, and what may be items of it."""
    if isinstance(value, Sequence):
        for item in value.items:
            if isinstance(item, Unknown) and item.many and item.options:
                yield from item.options
            else:
                yield item
    elif value is not None:
        yield value


def parameters_of(value: Value | None) -> Iterator[Parameters]:
    for item in items_of(value):
        if isinstance(item, Mapping):
            values = tuple((text_of(key), text_of(given)) for key, given in item.items.values())
            yield Parameters(item.span, None, values, not item.rest)
        elif isinstance(item, Unknown):
            yield Parameters(item.span, None, (), False)
        else:
            yield Parameters(item.span, text_of(item))


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
    told = given is None or (isinstance(given, Sequence) and given.complete) or isinstance(given, Mapping)
    return Include(
        call.span,
        argument_text(call, "launch_description_source"),
        tuple(pairs_of(given)),
        certain(call),
        told and call.rest is None,
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
