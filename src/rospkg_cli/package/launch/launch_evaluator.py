"""Evaluate a Python launch file as launch would run it; then the functions that launch may never call."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.known_functions import LIBRARY
from ...languages.python.evaluate.operators import path_join
from ...languages.python.evaluate.path_functions import PATH_FUNCTIONS
from ...languages.python.evaluate.sandbox_filesystem import SandboxFilesystem
from ...languages.python.evaluate.state import EvaluationState
from ...languages.python.evaluate.values import (
    Call,
    Class,
    Constant,
    Function,
    Namespace,
    PartialText,
    Text,
    Unknown,
    Value,
)
from ...languages.python.file import PythonFile
from ...source import Span
from .evaluated_launch import SubstitutionUse
from .include_helpers import KNOWN as HELPERS
from .include_helpers import made
from .launch_classes import class_of, is_substitution
from .substitution_tracking import SubstitutionTracker

ENTRIES = ("generate_launch_description", "generate_test_description")
"""What launch and launch_testing call."""


def stops_with(file: PythonFile) -> str:
    """Return the words before the name of an exception: what it ends, a launch or a test that launch_testing runs."""
    return f"the {'test' if ENTRIES[1] in file.definitions else 'launch'} stops with"


def found_path(machine: EvaluationState, call: Call) -> Value:
    """get_package_share_path: what is joined to it with `/` is a path below it."""
    machine.calls.append(call)
    return PartialText(call.span, (call,), is_path=True)


def as_path(machine: EvaluationState, call: Call) -> Value | None:
    """PathSubstitution(text): a path of one text, to be joined with `/`."""
    path = call.get("path", 0)
    return PartialText(call.span, (path,), is_path=True) if isinstance(path, Call) else None


def passed_on(machine: EvaluationState, call: Call) -> Value | None:
    """os.path.realpath and the like: of a path that is known only in part, the same path."""
    first = call.positional[0] if call.positional else None
    if isinstance(first, Text) and not first.text.startswith("/") and not call.callee.endswith("normpath"):
        return current_folder(machine, call)
    return first if isinstance(first, Call | PartialText) else PATH_FUNCTIONS[call.callee](machine, call)


def current_folder(machine: EvaluationState, call: Call) -> Value | None:
    """os.getcwd: the folder that the launch is started in, as a rule that of the workspace."""
    return machine.unknown(call.span, "it depends on the current folder")


def joined(receiver: PartialText, call: Call) -> Value | None:
    """Return what a method makes of a path in a share directory; None for a method that makes no path of it."""
    if call.callee == "joinpath":
        return path_join([receiver, *call.positional], call.span, path=True)
    return receiver if call.callee in SAME_PATH else None


def found_folder(machine: EvaluationState, finder: Call, call: Call) -> Value | None:
    """FindPackageShare(x).find(y): the folder of y; x is never looked for."""
    package = call.argument("package_name", 0)
    if package is None or len(call.arguments) != 1:
        return None
    if machine.calls and machine.calls[-1] is finder:
        machine.calls.pop()
    found = made(call, FINDERS[class_of(finder)], package)
    machine.calls.append(found)
    return found


def with_default(machine: EvaluationState, call: Call) -> Value | None:
    """os.environ.get and os.getenv: a default that is no text is a value that the launch may get."""
    found, name, default = LIBRARY[call.callee](machine, call), call.get("key", 0), call.get("default", 1)
    if isinstance(found, Unknown) and isinstance(default, Constant) and default.value is not None:
        shown = f"`{name.text}`" if isinstance(name, Text) else "the variable"
        return Unknown(found.span, f"{shown} may not be set", options=(default,))
    return found


def as_text(machine: EvaluationState, call: Call) -> Value | None:
    """str(x): whatever x may be, it is a text then; of a substitution the name of the object."""
    given = call.positional[0] if call.positional else None
    if given is not None and is_substitution(given):
        if isinstance(machine, SubstitutionTracker):
            machine.uses.append(SubstitutionUse(call.span, "operator", "str()", (given,)))
        return Unknown(call.span, "it holds the name of an object")
    found = LIBRARY["str"](machine, call)
    return Unknown(call.span, found.why) if isinstance(found, Unknown) and found.options else found


FINDERS = {
    "FindPackageShare": "ament_index_python.packages.get_package_share_directory",
    "FindPackagePrefix": "ament_index_python.packages.get_package_prefix",
    "FindPackage": "ament_index_python.packages.get_package_prefix",
}
"""Substitutions that find a folder, and the functions that return what their method `find` does."""

SAME_PATH = frozenset({"resolve", "absolute", "expanduser"})
PATHS = {
    "ament_index_python.get_package_share_path": found_path,
    "ament_index_python.packages.get_package_share_path": found_path,
    "launch.substitutions.PathSubstitution": as_path,
    "os.path.abspath": passed_on,
    "os.path.realpath": passed_on,
    "os.path.normpath": passed_on,
    "os.getcwd": current_folder,
    "pathlib.Path.cwd": current_folder,
    "os.environ.get": with_default,
    "os.getenv": with_default,
    "str": as_text,
    **HELPERS,
}
"""What makes a path that others are joined to, what gives it back, and what includes a file."""


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
