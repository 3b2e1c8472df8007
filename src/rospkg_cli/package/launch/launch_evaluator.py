"""Evaluate a Python launch file as launch would run it; then the functions that launch may never call."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.sandbox_filesystem import SandboxFilesystem
from ...languages.python.evaluate.values import (
    Call,
    Class,
    Function,
    Namespace,
    PartialText,
    Value,
)
from ...languages.python.file import PythonFile
from ...source import Span
from .launch_classes import class_of
from .path_calls import FINDERS, PATHS, found_folder, joined
from .substitution_tracking import SubstitutionTracker

ENTRIES = ("generate_launch_description", "generate_test_description")
"""What launch and launch_testing call."""


def stops_with(file: PythonFile) -> str:
    """Return the words before the name of an exception: what it ends, a launch or a test that launch_testing runs."""
    return f"the {'test' if ENTRIES[1] in file.definitions else 'launch'} stops with"


class LaunchEvaluator(SubstitutionTracker):
    """An evaluator that remembers which functions it has been in."""

    def __init__(self, file: PythonFile, folder: SandboxFilesystem) -> None:
        super().__init__(file, folder, PATHS, name="launch_file")
        self.entered: set[int] = set()
        self.active: list[int] = []
        self.results: dict[int, tuple[Function, Value]] = {}
        """What each function that launch calls returned, by the `id` of its node."""
        self.deferred: list[Span] = []
        """The functions that were not called by the file itself, nor by what launch calls of it."""

    def known_call(self, function: Value, receiver: Value | None, call: Call) -> Value | None:
        if isinstance(receiver, PartialText) and receiver.is_path and (found := joined(receiver, call)) is not None:
            return found
        if isinstance(receiver, Call) and call.callee == "find" and class_of(receiver) in FINDERS:
            return found_folder(self, receiver, call)
        return super().known_call(function, receiver, call)

    def run(self, function: Function, call: Call) -> Value:
        """Run a function; one that calls itself under an unknown condition is not followed."""
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
        """Run the file, then its entry points, the functions of OpaqueFunction, and every other function."""
        self.run_file()
        for name in ENTRIES:
            self.enter(self.get(name))
        uncalled = [each for each in functions_in(self.scope) if id(each.node) not in self.entered]
        self.deferred = [function.span for function in uncalled]
        done = 0
        while done < len(self.calls):
            call, done = self.calls[done], done + 1
            if class_of(call) == "OpaqueFunction":
                function = call.get("function", 0)
                self.deferred += [function.span] if isinstance(function, Function) else []
                self.enter(function)
        for function in list(functions_in(self.scope)):
            self.enter(function)

    def enter(self, function: Value | None) -> None:
        if isinstance(function, Function) and id(function.node) not in self.entered:
            self.results[id(function.node)] = function, self.call(function)


def functions_in(scope: Namespace, seen: set[int] | None = None) -> Iterator[Function]:
    """Yield the functions of a file, and the methods of its classes; a class with several names is looked at once."""
    seen = set() if seen is None else seen
    for value in list(scope.names.values()):
        if isinstance(value, Function):
            yield value
        elif isinstance(value, Class) and id(value) not in seen:
            seen.add(id(value))
            yield from functions_in(value.scope, seen)
